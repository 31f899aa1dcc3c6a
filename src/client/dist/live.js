/* carom. Contains three.js and uPlot, MIT; texts in src/client/LICENSES. */
"use strict";(()=>{function i(e,o,n={}){e.textContent=`${o.scene.title}: ${o.runs.length} runs${n.growing?", growing":""}`;let t=0;return{ready:Promise.resolve(),seek:r=>{t=r},play:()=>{},pause:()=>{},time:()=>t,destroy:()=>e.replaceChildren()}}})();
