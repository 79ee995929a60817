// All pages of the site, in the order of reading; a page is added here and nowhere else.
// [title, path without .md]; paths are those in docs/, or of what site/stage.mjs makes.
import { readFileSync } from 'node:fs'

// The commands are those that the program has: site/stage.mjs writes them down.
const commands = () => JSON.parse(readFileSync(new URL('../../build/site/commands.json', import.meta.url), 'utf8'))

export const sections = () => [
  { text: 'Start', items: [
    ['What Platen is for', 'index'],
    ['Install', 'how-to/install'],
    ['Your first law', 'tutorials/first-law'],
    ['Questions', 'questions'],
  ] },
  { text: 'Tutorials', items: [
    ['From a granule to LAMMPS', 'tutorials/granule-to-lammps'],
    ['From a measured curve to a law', 'tutorials/measured-curve'],
    ['A metal', 'tutorials/metal'],
    ['A rock', 'tutorials/rock'],
    ['A study on a cluster', 'tutorials/study-on-a-cluster'],
    ['Python', 'tutorials/python'],
  ] },
  { text: 'How-to', items: [
    ['Choose a law', 'how-to/choose-a-law'],
    ['Use your own material', 'how-to/your-own-material'],
    ['Get a law without a press', 'how-to/predict'],
    ['Read a file of a testing machine', 'how-to/measured-file'],
    ['Find the error of a law', 'how-to/error-of-a-law'],
    ['Look inside a particle', 'how-to/look-inside'],
    ['Press in a die or from all sides', 'how-to/confined'],
    ['Run a law in LAMMPS', 'how-to/lammps'],
    ['Use a law in another DEM code', 'how-to/other-dem-codes'],
    ['Mix unlike particles', 'how-to/unlike-particles'],
    ['Run a study', 'how-to/run-a-study'],
    ['When something fails', 'how-to/when-it-fails'],
  ] },
  { text: 'Explanation', items: [
    ['What was measured', 'explanation/what-was-measured'],
    ['What can be trusted', 'explanation/what-can-be-trusted'],
    ['Materials', 'explanation/materials'],
    ['The press', 'explanation/press'],
    ['Small contacts', 'explanation/local-press'],
    ['Confined particles', 'explanation/confined-press'],
    ['Reading a confined curve', 'explanation/confined-fits'],
    ['Which element, which contact', 'explanation/discretisation'],
    ['How large a step', 'explanation/step-size'],
    ['How well unloading is followed', 'explanation/unloading'],
    ['The published form and the curve', 'explanation/edmans-sinka-fit'],
    ['Unlike spheres and planes', 'explanation/dissimilar-spheres'],
    ['Two bodies of any two laws', 'explanation/joined'],
    ['How laws are predicted', 'explanation/predict'],
    ['How a law is calibrated', 'explanation/calibration'],
    ['Why the papers differ', 'explanation/papers'],
  ] },
  { text: 'Laws', items: [
    ['All laws', 'laws/index'],
    ['Which law for which material', 'laws/which-law'],
    ...['pressed', 'hertz', 'similarity', 'edmans-sinka', 'wang', 'agarwal', 'shahin', 'jackson-green', 'kogut-etsion',
      'etsion-unloading', 'thornton-ning', 'mdr', 'luding', 'eepa'].map(law => [law, `laws/${law}`]),
  ] },
  { text: 'Reference', items: [
    ['Files and exit codes', 'reference/index'],
    ['Notation and columns', 'notation'],
    ['Commands', 'reference/commands'],
    ...commands().map(name => [`platen ${name}`, `reference/commands/${name}`]),
    ['Material card', 'reference/material-card'],
    ['Case card', 'reference/case-card'],
    ['Study card', 'reference/study-card'],
    ['Law card', 'reference/law-card'],
    ['LAMMPS', 'reference/lammps'],
    ['Run store and exports', 'reference/study'],
    ['C++', 'reference/cpp'],
    ['C', 'reference/c'],
    ['Python package', 'reference/python'],
  ] },
  { text: 'Papers', items: [['The papers, reproduced', 'papers']] },
  { text: 'Gallery', items: [['Gallery', 'gallery']] },
  { text: 'About', items: [['Changes', 'changelog'], ['Contribute', 'contributing']] },
]
