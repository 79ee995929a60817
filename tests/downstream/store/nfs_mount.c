// nfs_mount URL FOLDER: mounts what an NFS server exports, by FUSE and libnfs, where no kernel client is at hand. One thread; names and
// attributes are believed for a second, as clients of NFS do.
#define FUSE_USE_VERSION 31
#include <errno.h>
#include <fcntl.h>
#include <fuse.h>
#include <nfsc/libnfs.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>

static struct nfs_context* nfs;

static struct nfsfh* handle(const struct fuse_file_info* info) { return (struct nfsfh*)(uintptr_t)info->fh; }

static void copy(const struct nfs_stat_64* from, struct stat* to) {
  memset(to, 0, sizeof *to);
  to->st_ino = from->nfs_ino, to->st_mode = from->nfs_mode, to->st_nlink = from->nfs_nlink;
  to->st_uid = from->nfs_uid, to->st_gid = from->nfs_gid, to->st_size = from->nfs_size;
  to->st_blksize = from->nfs_blksize, to->st_blocks = from->nfs_blocks;
  to->st_atim.tv_sec = from->nfs_atime, to->st_atim.tv_nsec = from->nfs_atime_nsec;
  to->st_mtim.tv_sec = from->nfs_mtime, to->st_mtim.tv_nsec = from->nfs_mtime_nsec;
  to->st_ctim.tv_sec = from->nfs_ctime, to->st_ctim.tv_nsec = from->nfs_ctime_nsec;
}

static int get_attributes(const char* path, struct stat* to, struct fuse_file_info* info) {
  (void)info;
  struct nfs_stat_64 from;
  const int error = nfs_lstat64(nfs, path, &from);
  if (error == 0) copy(&from, to);
  return error;
}

static int read_folder(const char* path, void* buffer, fuse_fill_dir_t fill, off_t offset, struct fuse_file_info* info,
                       enum fuse_readdir_flags flags) {
  (void)offset, (void)info, (void)flags;
  struct nfsdir* folder;
  const int error = nfs_opendir(nfs, path, &folder);
  if (error != 0) return error;
  for (struct nfsdirent* entry; (entry = nfs_readdir(nfs, folder));) fill(buffer, entry->name, NULL, 0, 0);
  nfs_closedir(nfs, folder);
  return 0;
}

static int make_folder(const char* path, mode_t mode) { return nfs_mkdir2(nfs, path, mode); }
static int remove_folder(const char* path) { return nfs_rmdir(nfs, path); }
static int remove_file(const char* path) { return nfs_unlink(nfs, path); }
static int rename_file(const char* from, const char* to, unsigned flags) {
  return flags ? -EINVAL : nfs_rename(nfs, from, to);
}
static int link_file(const char* from, const char* to) { return nfs_link(nfs, from, to); }

static int open_file(const char* path, struct fuse_file_info* info) {
  struct nfsfh* file;
  const int error = nfs_open(nfs, path, info->flags & (O_ACCMODE | O_TRUNC | O_APPEND), &file);
  info->fh = (uintptr_t)file;
  info->direct_io = 1; // what others write is seen
  return error;
}

static int create_file(const char* path, mode_t mode, struct fuse_file_info* info) {
  struct nfsfh* file;
  const int error = nfs_open2(nfs, path, (info->flags & (O_ACCMODE | O_EXCL | O_TRUNC)) | O_CREAT, mode, &file);
  info->fh = (uintptr_t)file;
  info->direct_io = 1;
  return error;
}

static int read_file(const char* path, char* to, size_t count, off_t offset, struct fuse_file_info* info) {
  (void)path;
  return nfs_pread(nfs, handle(info), offset, count, to);
}
static int write_file(const char* path, const char* from, size_t count, off_t offset, struct fuse_file_info* info) {
  (void)path;
  return nfs_pwrite(nfs, handle(info), offset, count, from);
}
static int sync_file(const char* path, int data, struct fuse_file_info* info) {
  (void)path, (void)data;
  return nfs_fsync(nfs, handle(info));
}
static int sync_folder(const char* path, int data, struct fuse_file_info* info) {
  (void)path, (void)data, (void)info;
  return 0; // servers answer once it is done
}
static int close_file(const char* path, struct fuse_file_info* info) {
  (void)path;
  return nfs_close(nfs, handle(info));
}
static int cut_file(const char* path, off_t length, struct fuse_file_info* info) {
  (void)info;
  return nfs_truncate(nfs, path, length);
}
static int change_mode(const char* path, mode_t mode, struct fuse_file_info* info) {
  (void)info;
  return nfs_chmod(nfs, path, mode);
}
static int change_times(const char* path, const struct timespec times[2], struct fuse_file_info* info) {
  (void)info;
  struct timeval both[2];
  for (int i = 0; i < 2; ++i) both[i].tv_sec = times[i].tv_sec, both[i].tv_usec = times[i].tv_nsec / 1000;
  return nfs_utimes(nfs, path, both);
}
static int may(const char* path, int mode) {
  (void)path, (void)mode;
  return 0;
}

static void* begin(struct fuse_conn_info* connection, struct fuse_config* config) {
  (void)connection;
  config->attr_timeout = config->entry_timeout = config->negative_timeout = 1;
  config->use_ino = 1;
  config->hard_remove = 1;
  return NULL;
}

int main(int argc, char** argv) {
  if (argc != 3) return fprintf(stderr, "usage: nfs_mount URL FOLDER\n"), 2;
  nfs = nfs_init_context();
  struct nfs_url* url = nfs ? nfs_parse_url_dir(nfs, argv[1]) : NULL;
  if (!url || nfs_mount(nfs, url->server, url->path) != 0)
    return fprintf(stderr, "nfs_mount: %s: %s\n", argv[1], nfs ? nfs_get_error(nfs) : "no memory"), 4;
  const struct fuse_operations operations = {
      .getattr = get_attributes, .readdir = read_folder, .mkdir = make_folder, .rmdir = remove_folder,
      .unlink = remove_file, .rename = rename_file, .link = link_file, .open = open_file, .create = create_file,
      .read = read_file, .write = write_file, .fsync = sync_file, .fsyncdir = sync_folder, .release = close_file,
      .truncate = cut_file, .chmod = change_mode, .utimens = change_times, .access = may, .init = begin};
  char* arguments[] = {argv[0], "-f", "-s", argv[2], NULL};
  return fuse_main(4, arguments, &operations, NULL);
}
