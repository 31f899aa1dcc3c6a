/* carom. Contains three.js and uPlot, MIT; texts in src/client/LICENSES. */
"use strict";(()=>{var Lr=[.05,.1,.25,.5,1,2,4,10];function bi(){return{position:new Float64Array(3),velocity:new Float64Array(3),spin:new Float64Array(3)}}var Ko=class{constructor(e,t,n,s){this.times=e;this.positions=t;this.velocities=n;this.spins=s}times;positions;velocities;spins;hint=0;get count(){return this.times.length}knotsUntil(e,t=!1){let{times:n}=this,s=l=>t?n[l]<e:n[l]<=e,r=this.hint;if((r===0||s(r-1))&&(r===n.length||!s(r)))return r;if(r<n.length&&s(r)&&(r+1===n.length||!s(r+1)))return this.hint=r+1;let a=0,o=n.length;for(;a<o;)r=a+o>>1,s(r)?a=r+1:o=r;return this.hint=a}at(e,t,n=!1){let{times:s}=this;if(s.length===0)return!1;let r=this.knotsUntil(e,n);return n&&r<s.length&&s[r]===e?this.copy(r,t):r===0||r===s.length?this.copy(r===0?0:r-1,t):this.between(r-1,e,t),!0}copy(e,t){for(let n=0;n<3;n+=1)t.position[n]=this.positions[3*e+n],t.velocity[n]=this.velocities[3*e+n],t.spin[n]=this.spins.length>0?this.spins[3*e+n]:0}between(e,t,n){let{times:s,positions:r,velocities:a,spins:o}=this,l=s[e+1]-s[e],c=(t-s[e])/l,[h,u]=[c*c,c*c*c],[d,f]=[3*e,3*e+3];for(let p=0;p<3;p+=1)n.position[p]=r[d+p]*(2*u-3*h+1)+a[d+p]*(l*(u-2*h+c))+r[f+p]*(3*h-2*u)+a[f+p]*(l*(u-h)),n.velocity[p]=a[d+p]+c*(a[f+p]-a[d+p]),n.spin[p]=o.length>0?o[d+p]+c*(o[f+p]-o[d+p]):0}};var q0=.06,Y0=24;function Qo(i,e){let t=[],n=bi(),{times:s,positions:r,velocities:a}=i;for(let o=0;o<i.count&&s[o]<=e;o+=1){let[l,c]=[r[3*o],r[3*o+1]],h=t.length-3;!(h>=0&&t[h+1]===l&&t[h+2]===c)||o+1===i.count?t.push(s[o],l,c):t[h]=s[o];let d=o+1<i.count?s[o+1]-s[o]:0;if(d>0){let f=$0(a,3*o,3*o+3),p=Math.min(Y0,Math.ceil(f/q0));for(let v=1;v<p;v+=1){let m=s[o]+d*v/p;i.at(m,n),t.push(m,n.position[0],n.position[1])}}}return Float64Array.from(t)}function $0(i,e,t){let n=i[e]*i[t+1]-i[e+1]*i[t],s=i[e]*i[t]+i[e+1]*i[t+1];return Math.abs(Math.atan2(n,s))}var Na=.45;function jo(i,e){let t=new Map(i.data.balls.map((a,o)=>[a.id,o])),[n,s]=[bi(),bi()],r=[];for(let a of e.events){let o=t.get(a.a);if(o===void 0||!e.paths[o]?.at(a.at,n))continue;let[l,c,h]=[n.position[0],n.position[1],i.radii[o]],u=t.get(a.b);if(a.kind==="ball-ball"&&u!==void 0&&e.paths[u]?.at(a.at,s)){let d=h/(h+i.radii[u]);r.push({at:a.at,x:l+d*(s.position[0]-l),y:c+d*(s.position[1]-c),r:1.25*Math.max(h,i.radii[u])})}else if(a.kind==="ball-cushion"){let d={x0:[-h,0],x1:[h,0],y0:[0,-h],y1:[0,h]},[f,p]=d[a.b]??[0,0];r.push({at:a.at,x:l+f,y:c+p,r:.8*h})}else a.kind==="pocket"&&r.push({at:a.at,x:l,y:c,r:1.6*h})}return r}function Dr(i,e){let t=e.every(l=>e.every(c=>l===c||Math.hypot(l.x-c.x,l.y-c.y)>l.r+c.r)),n=[[i.x0,i.y0],[i.x1,i.y0],[i.x1,i.y1],[i.x0,i.y1]],s=[],r=0,a=[];for(let l=0;l<4;l+=1){let[c,h]=n[l],[u,d]=n[(l+1)%4],f=Math.hypot(u-c,d-h),[p,v]=[(u-c)/f,(d-h)/f];a.push(r);for(let m of t?e:[]){let g=(m.x-c)*p+(m.y-h)*v,y=(m.x-c)*v-(m.y-h)*p;if(Math.abs(y)>=m.r)continue;let A=Math.sqrt(m.r*m.r-y*y);for(let b of[!0,!1]){let C=g+(b?-A:A);C>=0&&C<=f&&s.push({at:r+C,enters:b,pocket:m,x:c+C*p,y:h+C*v})}}r+=f}s.sort((l,c)=>l.at-c.at);let o=s.every((l,c)=>l.enters!==s[(c+1)%s.length].enters);return Z0(n,a,o&&s.length>1?s:[])}function Z0(i,e,t){let n={points:[],arcs:[],straights:[]},s=a=>({at:e[a],enters:!1,pocket:{x:0,y:0,r:0},x:i[a][0],y:i[a][1]});if(t.length===0){for(let a=0;a<4;a+=1)$h(n,s(a),s((a+1)%4),!1,!1);return n}let r=t.findIndex(a=>!a.enters);for(let a=0;a<t.length;a+=2){let o=t[(r+a)%t.length],l=t[(r+a+1)%t.length],c=e.map((m,g)=>({at:m,edge:g})).filter(({at:m})=>o.at<l.at?m>o.at&&m<l.at:m>o.at||m<l.at).sort((m,g)=>Af(m.at,o.at)-Af(g.at,o.at)),h=o,u=!0;for(let{edge:m}of c)$h(n,h,s(m),u,!1),h=s(m),u=!1;$h(n,h,l,u,!0);let d=t[(r+a+2)%t.length],{pocket:f}=l,p=Math.atan2(l.y-f.y,l.x-f.x),v=Math.atan2(d.y-f.y,d.x-f.x)-p;v+=v<=0?2*Math.PI:0,n.arcs.push({pocket:f,from:p,sweep:v});for(let m=0;m<28;m+=1){let g=p+v*m/28;n.points.push([f.x+f.r*Math.cos(g),f.y+f.r*Math.sin(g)])}}return n}function Af(i,e){return i>e?i:i+1e12}function $h(i,e,t,n,s){i.points.push([e.x,e.y]),Math.hypot(t.x-e.x,t.y-e.y)>1e-9&&i.straights.push({x0:e.x,y0:e.y,x1:t.x,y1:t.y,pocketBefore:n,pocketAfter:s})}var J0=["#f2b705","#1747b0","#d3202a","#4b2a86","#f26a1b","#0b6b3a","#7d1a22","#16181a"],Ef=["#c8452f","#2f6fb0","#e0a526","#3d8f63","#8a5aa8","#d9793a","#4aa0a8","#b0567c","#7a8a2e","#5a6b7a"],K0="#f6f1e4";function Rs(i,e){if(/^(cue|white)$/i.test(i))return{colour:K0,striped:!1,label:"",spotted:!0};let t=/^\d{1,2}$/.test(i)?Number(i):0;if(t>=1&&t<=15)return{colour:J0[(t-1)%8],striped:t>8,label:String(t),spotted:!1};let n=[...i].length<=3?i:[...i].slice(0,3).join("");return{colour:Ef[e%Ef.length],striped:!1,label:n,spotted:!1}}var Cf=[{light:"#0072b2",dark:"#4aa3e0",cloth:"#7cc8ff",dash:[],beats:0},{light:"#b84e00",dark:"#ff8a3c",cloth:"#ff9a4d",dash:[7,4],beats:8},{light:"#007a59",dark:"#2fc79a",cloth:"#9dffd8",dash:[2,3],beats:16},{light:"#a0437c",dark:"#e08ac0",cloth:"#ff9ddb",dash:[10,3,2,3],beats:5},{light:"#8a5f00",dark:"#edb93c",cloth:"#ffe066",dash:[14,5],beats:4},{light:"#1f7aa8",dark:"#9bd3f5",cloth:"#d5efff",dash:[5,2,1,2],beats:12},{light:"#1d2429",dark:"#e4e8eb",cloth:"#ffffff",dash:[1,2],beats:20}];function Qn(i){return Cf[i%Cf.length]}function Zh(i){return matchMedia("(prefers-color-scheme: dark)").matches?Qn(i).dark:Qn(i).light}function Rf(i,e){let[t,n]=i.origin,s=(m,g)=>[(m-t)/i.R,(g-n)/i.R],r=Float64Array.from(i.balls,m=>m.radius/i.R),a=i.pockets.map(([m,g,y])=>{let[A,b]=s(m,g);return{x:A,y:b,r:y/i.R}}),{moved:o,floor:l}=Q0(e,r),c=null;if(i.table){let[m,g]=s(...i.table.min),[y,A]=s(...i.table.max);c={x0:m,y0:g,x1:y,y1:A}}let h=qn(o,Math.max(4,.12*Math.max(o.x1-o.x0,o.y1-o.y0))),u=c?qn(c,1.25+2.9):h,d=qn(o,6),f=[u,d].map(m=>Math.max(m.x1-m.x0,m.y1-m.y0)),p=f[0]>90&&f[0]>4*f[1],v=Math.max(0,...e.map(m=>m.facts.end));return{data:i,runs:e,table:c,pockets:a,cloth:c??h,sight:p?d:u,floor:l,radii:r,end:v}}function qn(i,e){return{x0:i.x0-e,y0:i.y0-e,x1:i.x1+e,y1:i.y1+e}}function Q0(i,e){let t={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0},n=1/0;for(let s of i)s.paths.forEach((r,a)=>{let o=e[a];for(let l=0;l<r.positions.length;l+=3){let[c,h,u]=[r.positions[l],r.positions[l+1],r.positions[l+2]];Number.isFinite(c+h+u)&&(t.x0=Math.min(t.x0,c-o),t.y0=Math.min(t.y0,h-o),t.x1=Math.max(t.x1,c+o),t.y1=Math.max(t.y1,h+o),n=Math.min(n,u-o))}});return Number.isFinite(t.x1-t.x0+t.y1-t.y0)?{moved:t,floor:Number.isFinite(n)?n:0}:{moved:{x0:-10,y0:-10,x1:10,y1:10},floor:0}}function Ps(i){if(!i.apart)return[i.solid];let e=i.shown.flatMap((t,n)=>t||n===i.solid?[n]:[]);return e.length>0?e:[i.solid]}function el(i,e){return i.apart?[]:i.shown.flatMap((t,n)=>t&&n!==e?[n]:[])}function tl(i,e){let[t,n]=[i.x1-i.x0,i.y1-i.y0];return{zoom:Math.min(1,Math.max((e.x1-e.x0)/t,(e.y1-e.y0)/n)),x:(e.x0+e.x1-i.x0-i.x1)/2,y:(e.y0+e.y1-i.y0-i.y1)/2}}function tr(i,e,t,n){let[s,r]=[i.x1-i.x0,i.y1-i.y0],a={columns:1,rows:e,lying:!0,scale:0};for(let h=1;h<=e;h+=1){let u=Math.ceil(e/h);for(let d of[!0,!1]){let[f,p]=d?[r,s]:[s,r],v=Math.min(t/h/f,n/u/p);v>a.scale&&(a={columns:h,rows:u,lying:d,scale:v})}}let[o,l]=[t/a.columns,n/a.rows];return{cells:Array.from({length:e},(h,u)=>({x:u%a.columns*o,y:Math.floor(u/a.columns)*l,width:o,height:l})),lying:a.lying}}function nl(i,e,t){return i.findIndex(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)}var Pf=.03,j0=.4;function il(i,e,t){let n=Math.hypot(i[3*t]-e[3*t],i[3*t+1]-e[3*t+1],i[3*t+2]-e[3*t+2]),s=Math.min(1,Math.max(0,(n-Pf)/(j0-Pf)));return s*s*(3-2*s)}var Is=class{constructor(e,t){this.stage=e;this.still=t;let n=this.canvas.getContext("2d");if(!n)throw new Error("this browser has no canvas");this.pen=n}stage;still;canvas=document.createElement("canvas");pen;marksOf=new Map;lines=new Map;width=1;height=1;ratio=1;closer=1;middle=[0,0];shift=[0,0];drawn=null;look(){this.close(null)}close(e){let{zoom:t,x:n,y:s}=e?tl(this.stage.sight,e):{zoom:1,x:0,y:0};this.closer=1/t,this.middle=[n,s],this.shift=[0,0]}orbit(e,t){this.pan(-e,t)}zoom(e){this.closer=Math.min(25,Math.max(.5,this.closer/e))}pan(e,t){this.shift[0]-=e*this.height,this.shift[1]+=t*this.height}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t),this.ratio=Math.min(2,window.devicePixelRatio||1),this.canvas.width=Math.round(this.width*this.ratio),this.canvas.height=Math.round(this.height*this.ratio)}draw(e,t,n){this.drawn={frame:e,choice:t};let{pen:s,ratio:r}=this;s.setTransform(r,0,0,r,0,0),s.clearRect(0,0,this.width,this.height);let a=Ps(t),{cells:o,lying:l}=tr(this.stage.sight,a.length,this.width,this.height);return a.forEach((c,h)=>{let u=o[h];s.save(),s.beginPath(),s.rect(u.x,u.y,u.width,u.height),s.clip(),this.one(e,t,c,n,this.lens(u,l)),s.restore()}),!1}pick(e,t){if(!this.drawn)return-1;let{frame:n,choice:s}=this.drawn,r=Ps(s),{cells:a,lying:o}=tr(this.stage.sight,r.length,this.width,this.height),l=nl(a,e,t);if(l<0)return-1;let c=this.lens(a[l],o),h=n.scatters[r[l]],u={ball:-1,distance:18};for(let d=0;d<h.present.length;d+=1){let[f,p]=ss(c,h.positions[3*d],h.positions[3*d+1]),v=Math.hypot(f-e,p-t);h.present[d]&&v<u.distance&&(u={ball:d,distance:v})}return u.ball}dispose(){this.canvas.remove()}lens(e,t){let{sight:n}=this.stage,[s,r]=[n.x1-n.x0,n.y1-n.y0];return{scale:.96*this.closer*Math.min(e.width/(t?r:s),e.height/(t?s:r)),lying:t,px:e.x+e.width/2+this.shift[0],py:e.y+e.height/2+this.shift[1],cx:(n.x0+n.x1)/2+this.middle[0],cy:(n.y0+n.y1)/2+this.middle[1]}}one(e,t,n,s,r){let a=e.scatters[n],o=el(t,n);this.table(r),t.trails&&(o.forEach(l=>this.trails(l,e.time,!0,r)),this.trails(n,e.time,!1,r)),t.marks&&this.rings(n,e.time,Na*s,r),this.ring(r,a,t.ball,1.2,.1,"rgba(255,255,255,.8)");for(let l=0;l<this.stage.radii.length;l+=1)a.present[l]&&this.ball(r,a,l);o.forEach(l=>this.ghosts(r,e.scatters[l],a,l));for(let l of t.called)this.ring(r,a,l,1.11,.18,"#ffe98a")}table(e){let{pen:t,stage:n}=this,s=(a,o)=>{t.beginPath();for(let[l,c]of a)t.lineTo(...ss(e,l,c));t.closePath(),t.fillStyle=o,t.fill()},r=a=>[[a.x0,a.y0],[a.x1,a.y0],[a.x1,a.y1],[a.x0,a.y1]];n.table&&(s(r(qn(n.table,1.25+2.9)),"#5a2b17"),s(Dr(qn(n.table,1.25),n.pockets).points,"#0b4a38")),s(r(n.cloth),"#12694f");for(let{x:a,y:o,r:l}of n.pockets)this.disc(e,a,o,l,"#0a0908")}disc(e,t,n,s,r){let{pen:a}=this;a.beginPath(),a.arc(...ss(e,t,n),Math.max(.5,s*e.scale),0,2*Math.PI),a.fillStyle=r,a.fill()}ball(e,t,n){let{pen:s,stage:r}=this,{colour:a,striped:o,label:l,spotted:c}=Rs(r.data.balls[n].id,n),[h,u]=[t.positions[3*n],t.positions[3*n+1]],[d,f]=ss(e,h,u),p=Math.max(1.5,r.radii[n]*e.scale);this.disc(e,h+.12,u-.12,r.radii[n],"rgba(0,0,0,.3)"),s.save(),s.beginPath(),s.arc(d,f,p,0,2*Math.PI),s.fillStyle=o?"#f4efe2":a,s.fill(),s.clip(),o&&(s.fillStyle=a,s.fillRect(d-p,f-.55*p,2*p,1.1*p)),c&&(s.fillStyle="#c4202b",s.beginPath(),s.arc(d,f,.16*p,0,2*Math.PI),s.fill()),s.restore(),l&&p>5&&(s.fillStyle="#f4efe2",s.beginPath(),s.arc(d,f,.5*p,0,2*Math.PI),s.fill(),s.fillStyle="#16181a",s.font=`700 ${Math.round((l.length>2?.42:l.length>1?.58:.75)*p)}px Arial, sans-serif`,s.textAlign="center",s.textBaseline="middle",s.fillText(l,d,f+.03*p))}ghosts(e,t,n,s){let{pen:r,stage:a}=this,{cloth:o,dash:l}=Qn(s);for(let c=0;c<a.radii.length;c+=1){let h=t.present[c]?n.present[c]?il(t.positions,n.positions,c):1:0;h<=0||(r.globalAlpha=h,r.beginPath(),r.arc(...ss(e,t.positions[3*c],t.positions[3*c+1]),Math.max(1.5,a.radii[c]*e.scale),0,2*Math.PI),r.fillStyle=`${o}44`,r.fill(),r.strokeStyle=o,r.lineWidth=2,r.setLineDash(l.map(u=>u*.6)),r.stroke())}r.globalAlpha=1,r.setLineDash([])}ring(e,t,n,s,r,a){if(n<0||!t.present[n])return;let{pen:o}=this;o.beginPath(),o.arc(...ss(e,t.positions[3*n],t.positions[3*n+1]),s*this.stage.radii[n]*e.scale,0,2*Math.PI),o.strokeStyle=a,o.lineWidth=Math.max(1.2,r*e.scale),o.stroke()}rings(e,t,n,s){let{pen:r}=this,a=this.marksOf.get(e);a||(a=jo(this.stage,this.stage.runs[e]),this.marksOf.set(e,a));for(let o of a){let l=(t-o.at)/n;l<0||l>1||(r.beginPath(),r.arc(...ss(s,o.x,o.y),o.r*s.scale*(this.still()?1:1+.9*l),0,2*Math.PI),r.strokeStyle=`rgba(255,247,217,${.9*(1-l)})`,r.lineWidth=2,r.stroke())}}trails(e,t,n,s){let{pen:r,stage:a}=this,o=this.lines.get(e);o||(o=a.runs[e].paths.map((l,c)=>Qo(l,a.runs[e].leaves[c])),this.lines.set(e,o)),r.lineWidth=1.5,r.globalAlpha=.7,r.setLineDash(n?[5,4]:[]),o.forEach((l,c)=>{r.strokeStyle=n?Qn(e).cloth:Rs(a.data.balls[c].id,c).colour,r.beginPath();for(let h=0;h<l.length&&l[h]<=t;h+=3)if(r.lineTo(...ss(s,l[h+1],l[h+2])),h+3<l.length&&l[h+3]>t){let u=(t-l[h])/(l[h+3]-l[h]);r.lineTo(...ss(s,l[h+1]+u*(l[h+4]-l[h+1]),l[h+2]+u*(l[h+5]-l[h+2])))}r.stroke()}),r.globalAlpha=1,r.setLineDash([])}};function ss(i,e,t){let[n,s]=[(e-i.cx)*i.scale,(t-i.cy)*i.scale];return i.lying?[i.px+s,i.py+n]:[i.px+n,i.py-s]}var sl=class{constructor(e){this.end=e;this.base=e>=.5&&e<=120?1:e/10||1}end;shown=0;running=!1;factor=1;last=0;request=0;listeners=new Set;base;get time(){return this.shown}get playing(){return this.running}get rate(){return this.factor}set rate(e){this.factor=e,this.tell()}listen(e){this.listeners.add(e)}seek(e){this.shown=Math.min(this.end,Math.max(0,Number.isFinite(e)?e:0)),this.tell()}play(){this.running||(this.shown>=this.end&&(this.shown=0),this.running=!0,this.last=performance.now(),this.request=requestAnimationFrame(this.step),this.tell())}pause(){cancelAnimationFrame(this.request),this.running&&(this.running=!1,this.tell())}stop(){this.listeners.clear(),this.pause()}step=e=>{let t=Math.min(.25,Math.max(0,(e-this.last)/1e3));this.last=e,this.shown=Math.min(this.end,this.shown+t*this.factor*this.base),this.running=this.shown<this.end,this.running&&(this.request=requestAnimationFrame(this.step)),this.tell()};tell(){for(let e of this.listeners)e(this)}};function fe(i,e={},...t){let n=document.createElement(i);return If(n,e),n.append(...t),n}var ex="http://www.w3.org/2000/svg";function Hi(i,e={},...t){let n=document.createElementNS(ex,i);return If(n,e),n.append(...t),n}function rl(i){return Hi("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},Hi("path",{d:i}))}function rs(i,e,t){let n=fe("button",{type:"button","aria-label":i,title:i},...e);return n.addEventListener("click",t),n}function If(i,e){for(let[t,n]of Object.entries(e))n!==void 0&&n!==!1&&i.setAttribute(t,n===!0?"":String(n))}function di(i,e){i.textContent!==e&&(i.textContent=e)}function Jh(i,e=5){return i>0&&Number.isFinite(i)?Math.min(15,Math.max(0,e-Math.ceil(Math.log10(i)))):3}function nr(i,e=4){if(!Number.isFinite(i))return"–";if(i===0)return"0";let t=Math.abs(i);if(t>=1e6||t<.001)return i.toExponential(e-2).replace(/\.?0*e\+?/,"e");let n=i.toPrecision(e);return n.includes("e")?String(Number(n)):n.replace(/(\.\d*?)0+$/,"$1").replace(/\.$/,"")}function Tn(i,e){return i.toFixed(Jh(e))}var tx=7,nx=10;async function Lf(i,e){let t=i.counts.reduce((d,f)=>d+f,0),n=e.rotates?nx:tx,s=await sx(ix(i.bytes));if(s.length!==t*n*4)throw new Error(`the knots hold ${s.length} bytes where ${t} knots of ${n} columns need ${t*n*4}`);let r=e.scene.speed_scale/e.R,a=(d,f)=>rx(s,d*t,t,f),o=a(0,1),l=[1,2,3].map(d=>a(d,1)),c=[4,5,6].map(d=>a(d,r)),h=e.rotates?[7,8,9].map(d=>a(d,r)):[],u=0;return i.counts.map(d=>{let f=u+d,p=m=>m.subarray(u,f),v=new Ko(p(o),Kh(l.map(p)),Kh(c.map(p)),Kh(h.map(p)));return u=f,v})}function ix(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n+=1)t[n]=e.charCodeAt(n);return t}async function sx(i){let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate-raw"));return new Uint8Array(await new Response(e).arrayBuffer())}function rx(i,e,t,n){let s=u=>e*4+u*t,[r,a,o,l]=[s(0),s(1),s(2),s(3)],c=new DataView(new ArrayBuffer(4)),h=new Float64Array(t);for(let u=0;u<t;u+=1){let d=i[l+u]<<24|i[o+u]<<16|i[a+u]<<8|i[r+u];c.setInt32(0,d),h[u]=c.getFloat32(0)*n}return h}function Kh(i){let[e,t,n]=i;if(!e)return new Float64Array(0);let s=new Float64Array(3*e.length);for(let r=0;r<e.length;r+=1)s[3*r]=e[r],s[3*r+1]=t[r],s[3*r+2]=n[r];return s}function ax(i,e,t,n){let s=Math.hypot(e,t,n),r=s>1e-8?Math.sin(s/2)/s:.5,[a,o,l,c]=[r*e,r*t,r*n,Math.cos(s/2)],[h,u,d,f]=i;i[0]=c*h+a*f+o*d-l*u,i[1]=c*u-a*d+o*f+l*h,i[2]=c*d+a*u-o*h+l*f,i[3]=c*f-a*h-o*u-l*d;let p=Math.hypot(i[0],i[1],i[2],i[3]);for(let v=0;v<4;v+=1)i[v]/=p}function Df(i,e,t,n,s,r,a){let o=(m,g)=>e[t+m]+g*(e[n+m]-e[t+m]),[l,c,h]=[o(0,r),o(1,r),o(2,r)],[u,d,f]=[o(0,a),o(1,a),o(2,a)],p=s*(a-r),v=p*p/12;ax(i,p*(l+u)/2+v*(d*h-f*c),p*(c+d)/2+v*(f*l-u*h),p*(h+f)/2+v*(u*c-d*l))}var al=class{constructor(e){this.path=e;let{times:t,spins:n,count:s}=e,r=new Float64Array([0,0,0,1]);for(let a=0;a<s;a+=1){this.push(t[a],a,0,r);let o=a+1<s?t[a+1]-t[a]:0;if(o>0&&n.length>0){let[l,c]=[3*a,3*a+3],h=ox(n,l,c,o);for(let u=1;u<=h;u+=1)Df(r,n,l,c,o,(u-1)/h,u/h),u<h&&this.push(t[a]+o*u/h,a,u/h,r)}}}path;times=[];nodes=[];knots=[];parts=[];hint=0;at(e,t){let{times:n,nodes:s,path:r}=this;if(n.length-1<0||r.spins.length===0){t.set([0,0,0,1]);return}let o=this.find(e);for(let c=0;c<4;c+=1)t[c]=s[4*o+c];let l=this.knots[o];if(e>n[o]&&l+1<r.count){let c=r.times[l+1]-r.times[l],h=Math.min(1,(e-r.times[l])/c);Df(t,r.spins,3*l,3*l+3,c,this.parts[o],h)}}push(e,t,n,s){this.times.push(e),this.knots.push(t),this.parts.push(n),this.nodes.push(s[0],s[1],s[2],s[3])}find(e){let{times:t}=this,n=this.hint;if(t[n]<=e&&(n+1===t.length||t[n+1]>e))return n;let s=0,r=t.length;for(;s<r;){let a=s+r>>1;t[a]<=e?s=a+1:r=a}return this.hint=Math.max(0,s-1)}};function ox(i,e,t,n){let[s,r,a,o,l,c]=[i[e],i[e+1],i[e+2],i[t],i[t+1],i[t+2]],h=Math.hypot(l*a-c*r,c*s-o*a,o*r-l*s),[u,d]=[Math.hypot(s,r,a),Math.hypot(o,l,c)];return h<=1e-9*u*d?1:Math.min(4096,Math.max(1,Math.ceil(n*Math.max(u,d)/.5)))}async function Nf(i){let e=new Map(i.balls.map((t,n)=>[t.id,n]));return Promise.all(i.runs.map(async(t,n)=>{let s=await Lf(t.knots,i),r=new Float64Array(i.balls.length).fill(1/0),a=t.events.map(([l,c,h,u])=>({at:Math.fround(l),time:l,kind:c,a:h,b:u}));for(let l of a){let c=e.get(l.a);l.kind==="pocket"&&c!==void 0&&(r[c]=l.at)}let o=i.rotates?s.map(l=>new al(l)):[];return{facts:t,index:n,paths:s,turnings:o,events:a,leaves:r}}))}function ol(i){switch(i.kind){case"ball-ball":return`${i.a} hits ${i.b}`;case"ball-cushion":return`${i.a} meets cushion ${i.b}`;case"stop":return`${i.a} stops`;case"slide-to-roll":return`${i.a} starts to roll`;case"spin-end":return`${i.a} stops to spin`;case"pocket":return`${i.a} falls in pocket ${i.b.replace(/^p/,"")}`;default:return[i.kind,i.a,i.b].filter(Boolean).join(" ")}}function Ua(i,e){let t=0,n=i.length;for(;t<n;){let s=t+n>>1;i[s].at<=e?t=s+1:n=s}return t}var Ff="M8 5v14l11-7z",lx="M6 5h4v14H6zM14 5h4v14h-4z",cx="M6 6l8.5 6L6 18zM16 6h2v12h-2z",hx="M18 6l-8.5 6L18 18zM6 6h2v12H6z",ux="M11 21v-7L5.6 8.6 4 10V4h6L8.4 5.6 12 9.2l3.6-3.6L14 4h6v6l-1.6-1.4L13 14v7z",ll=class{constructor(e,t,n,s){this.stage=e;this.clock=t;let r=e.data.scene.time_unit;this.shape=Hi("path",{d:Ff}),this.play=rs("Play",[Hi("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"rp-icon"},this.shape)],()=>n.toggle()),this.play.classList.add("rp-play"),this.rates=fe("select",{"aria-label":"Speed",title:t.base===1?`1x: one ${r} in one second`:"1x: the longest run in ten seconds"}),this.rates.append(...Lr.map(u=>fe("option",{value:u,selected:u===1},`${u}×`))),this.rates.addEventListener("change",()=>n.rate(Number(this.rates.value))),this.scrubber=fe("input",{type:"range",min:0,max:e.end||1,step:"any",value:0,class:"rp-scrub","aria-label":"Time"}),this.scrubber.addEventListener("input",()=>n.seek(Number(this.scrubber.value)));let a=fe("div",{class:"rp-transport",role:"group","aria-label":"Playback"},rs("Event before",[rl(hx)],()=>n.event(-1)),this.play,rs("Next event",[rl(cx)],()=>n.event(1))),o=fe("div",{class:"rp-row"},a,fe("span",{class:"rp-clock"},this.now,fe("span",{class:"rp-end"},` / ${Tn(e.end,e.end)} ${r}`)),this.rates);if(e.data.partings.length>0){let u=e.data.partings[0].time;this.jump=rs("Jump to the first divergence",[rl(ux),fe("span",{},"First divergence"),fe("span",{class:"rp-at"},`${Tn(u,e.end)} ${r}`)],()=>n.parting()),this.jump.classList.add("rp-jump"),o.append(this.jump)}else e.runs.length>1&&o.append(fe("span",{class:"rp-none"},"No collision order differs"));o.append(this.last);let l=fe("div",{class:"rp-views",role:"group","aria-label":"Camera"}),c=s?[["above","From above"],["free","Free"],["flat","Flat"]]:[["flat","Flat"]];for(let[u,d]of c){let f=fe("button",{type:"button","aria-pressed":"false"},d);f.addEventListener("click",()=>n.look(u)),this.cameras.set(u,f),l.append(f)}this.boxes={apart:e.runs.length>1?this.box("Side by side",u=>n.apart(u)):null,trails:this.box("Trails",u=>n.trails(u)),marks:this.box("Hits",u=>n.marks(u))};let h=fe("div",{class:"rp-row rp-looks"},l);for(let u of[this.boxes.apart,this.boxes.trails,this.boxes.marks])u?.parentElement&&h.append(u.parentElement);this.element=fe("div",{class:"rp-controls"},fe("div",{class:"rp-time"},this.scrubber,this.ticks),o,h)}stage;clock;element;scrubber;play;shape;now=fe("output",{class:"rp-now"});last=fe("span",{class:"rp-event"});rates;jump=null;ticks=Hi("svg",{class:"rp-ticks",viewBox:"0 0 1000 12",preserveAspectRatio:"none","aria-hidden":"true"});cameras=new Map;boxes;spoken=-1/0;tell(e){let{clock:t,stage:n}=this,s=Tn(t.time,n.end);di(this.now,s),this.scrubber.value=String(t.time),this.scrubber.style.setProperty("--rp-part",String(n.end>0?t.time/n.end:0));let r=Ua(e,t.time),a=r>0?`event ${r} of ${e.length}: ${ol(e[r-1])}`:`${e.length} events to come`;di(this.last,a);let o=performance.now();(!t.playing||o-this.spoken>1e3)&&(this.spoken=o,this.scrubber.setAttribute("aria-valuetext",`${s} ${n.data.scene.time_unit}, ${a}`));let l=t.playing?"Pause":"Play";this.play.title!==l&&(this.play.title=l,this.play.setAttribute("aria-label",l),this.shape.setAttribute("d",t.playing?lx:Ff)),this.rates.value=String(t.rate)}choose(e){for(let[t,n]of this.cameras)n.setAttribute("aria-pressed",String(t===e.camera));this.boxes.apart&&(this.boxes.apart.checked=e.apart),this.boxes.trails.checked=e.trails,this.boxes.marks.checked=e.marks}mark(e){let{data:t,end:n}=this.stage,s=h=>(1e3*h/(n||1)).toFixed(2),r={"ball-ball":9,"ball-cushion":6,pocket:9,stop:3},a=(h,u)=>Hi("path",{d:u,class:`rp-tick ${h}`,"vector-effect":"non-scaling-stroke"}),o=Object.entries(r).map(([h,u])=>{let d=e.filter(f=>f.kind===h).map(f=>`M${s(f.at)} 0v${u}`);return a(`rp-${h}`,d.join(""))}),l=t.partings.map(h=>a("rp-part",`M${s(h.time)} 0v12`)),c=t.horizon===null?[]:[a("rp-horizon",`M${s(t.horizon)} 0v12`)];this.ticks.replaceChildren(...o,...c,...l)}box(e,t){let n=fe("input",{type:"checkbox"});return n.addEventListener("change",()=>t(n.checked)),fe("label",{class:"rp-check"},n,e),n}};var cl=class{constructor(e){this.stage=e;let t=e.data.balls.length;this.scatters=e.runs.map(n=>({run:n,positions:new Float64Array(3*t),velocities:new Float64Array(3*t),spins:new Float64Array(3*t),orientations:new Float64Array(4*t).map((s,r)=>r%4===3?1:0),present:new Uint8Array(t)}))}stage;time=0;scatters;motion=bi();quaternion=new Float64Array(4);go(e){this.time=e;let{motion:t,quaternion:n,stage:s}=this;for(let r of this.scatters){let{run:a}=r;for(let o=0;o<s.radii.length;o+=1){let l=a.paths[o],c=l!==void 0&&l.at(e,t);r.present[o]=c&&e<a.leaves[o]?1:0,c&&(r.positions.set(t.position,3*o),r.velocities.set(t.velocity,3*o),r.spins.set(t.spin,3*o)),s.data.rotates&&c&&(a.turnings[o].at(e,n),r.orientations.set(n,4*o))}}}};function Uf(i,e){let t=new Map,n=0,s=0;i.addEventListener("pointerdown",a=>{t.set(a.pointerId,{x:a.clientX,y:a.clientY}),n=t.size===1?0:5,s=0,i.setPointerCapture(a.pointerId)}),i.addEventListener("pointermove",a=>{let o=t.get(a.pointerId),l=e.view();if(!o||!l)return;let[c,h]=[a.clientX-o.x,a.clientY-o.y];n+=Math.hypot(c,h),t.set(a.pointerId,{x:a.clientX,y:a.clientY});let{width:u,height:d}=i.getBoundingClientRect();if(t.size===1)a.shiftKey||(a.buttons&2)!==0?l.pan(-c/d,h/d):l.orbit(c/u,h/d);else{let[f,p]=[...t.values()],v=Math.hypot(f.x-p.x,f.y-p.y);s>0&&v>0&&l.zoom(s/v),s=v,l.pan(-c/2/d,h/2/d)}e.again()});let r=a=>{if(t.delete(a.pointerId)&&n<5&&a.type==="pointerup"){let o=i.getBoundingClientRect();e.choose(e.view()?.pick(a.clientX-o.left,a.clientY-o.top)??-1)}s=0};i.addEventListener("pointerup",r),i.addEventListener("pointercancel",r),i.addEventListener("contextmenu",a=>a.preventDefault()),i.addEventListener("wheel",a=>{(a.ctrlKey||document.activeElement===i)&&(a.preventDefault(),e.view()?.zoom(Math.exp(.0015*a.deltaY)),e.again())},{passive:!1})}var dx=[["Space","play, pause"],["← →","back and on by a hundredth of the shot; with Alt by a thousandth"],[", .","event before, next event"],["d","first divergence, then the next"],["Home End","start, end"],["[ ]","slower, faster"],["v","next camera"],["t","trails"],["Shift + arrows","turn and tilt the camera"],["+ − 0","closer, farther, the whole table"],["?","this list"]];function Of(){let i=dx.map(([e,t])=>fe("div",{},fe("dt",{},...e.split(" ").map(n=>fe("kbd",{},n))),fe("dd",{},t)));return fe("details",{class:"rp-keys"},fe("summary",{},"Keys"),fe("dl",{},...i))}function Bf(i,e){i.addEventListener("keydown",t=>{!t.ctrlKey&&!t.metaKey&&fx(t,e)&&t.preventDefault()})}function fx(i,e){let{actions:t}=e,n=i.target,s=n.closest("select, button, summary, input:not([type=range])");if(s&&(i.key===" "||i.key==="Enter"||i.key.startsWith("Arrow")&&s.matches("select, input")))return!1;let a={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[i.key];if(a&&i.shiftKey)return e.view()?.orbit(.04*a[0],.04*a[1]),e.again(),!0;if(a&&(a[0]!==0||n.matches("input[type=range]")))return t.nudge((a[0]-a[1])*(i.altKey?.001:.01)),!0;let l={" ":()=>t.toggle(),".":()=>t.event(1),",":()=>t.event(-1),d:()=>t.parting(),Home:()=>t.seek(0),End:()=>t.seek(e.end()),PageUp:()=>t.nudge(.1),PageDown:()=>t.nudge(-.1),"[":()=>t.faster(-1),"]":()=>t.faster(1),v:()=>e.nextCamera(),t:()=>e.toggleTrails(),"+":()=>hl(e,.85),"=":()=>hl(e,.85),"-":()=>hl(e,1/.85),0:()=>hl(e,0),"?":()=>{e.keys.open=!e.keys.open}}[i.key];return l?.(),l!==void 0}function hl(i,e){e===0?i.actions.look(i.camera()):(i.view()?.zoom(e),i.again())}var ul=class{element;shown=[];solid=[];rows=[];constructor(e,t){this.element=fe("fieldset",{class:"rp-legend"},fe("legend",{},"Engines"));let n=`rp-solid-${Math.random().toString(36).slice(2)}`,s=e.data.scene.time_unit;for(let{facts:r,index:a}of e.runs){let o=fe("input",{type:"checkbox","aria-label":`Show ${r.label}`});o.addEventListener("change",()=>t.show(a,o.checked));let l=fe("input",{type:"radio",name:n,"aria-label":`Balls of ${r.label} solid`});l.addEventListener("change",()=>t.solid(a)),this.shown.push(o),this.solid.push(l);let c=fe("span",{class:"rp-name"},r.label,...r.reference?[fe("small",{},"reference")]:[]),h=fe("span",{class:"rp-ending"},`${r.ending}, ${Tn(r.end,e.end)} ${s}`),u=fe("div",{class:"rp-run"},fe("label",{class:"rp-show"},o,dl(a),c));e.runs.length>1&&u.append(fe("label",{class:"rp-solid"},l,"solid")),u.append(h),e.data.partings.forEach((d,f)=>{if(d.runs[0]===a){let p=e.runs[d.runs[1]]?.facts.label??"",v=fe("button",{type:"button",class:"rp-parts",title:d.words},`parts from ${p} at ${Tn(d.time,e.end)} ${s}`);v.addEventListener("click",()=>t.parting(f)),u.append(v)}}),this.rows.push(u),this.element.append(u)}}choose(e){this.shown.forEach((t,n)=>{t.checked=e.shown[n]||n===e.solid,t.disabled=n===e.solid,this.solid[n].checked=n===e.solid,this.rows[n].classList.toggle("rp-off",!t.checked)})}};function dl(i){let e=Hi("line",{x1:0,y1:5,x2:34,y2:5,class:`rp-ink${i%7}`,"stroke-width":2.5,"stroke-dasharray":Qn(i).dash.join(" ")||"none"});return Hi("svg",{viewBox:"0 0 34 10",class:"rp-swatch","aria-hidden":"true"},e)}var px="uplot",mx="u-hz",gx="u-vt",xx="u-title",_x="u-wrap",vx="u-under",yx="u-over",bx="u-axis",rr="u-off",Mx="u-select",Sx="u-cursor-x",wx="u-cursor-y",Tx="u-cursor-pt",Ax="u-legend",Ex="u-live",Cx="u-inline",Rx="u-series",Px="u-marker",kf="u-label",Ix="u-value",Ba="width",ka="height";var zf="bottom",Nr="left",Qh="right",mu="#000",Vf=mu+"0",jh="mousemove",Gf="mousedown",eu="mouseup",Hf="mouseenter",Wf="mouseleave",Xf="dblclick",Lx="resize",Dx="scroll",qf="change",xl="dppxchange",gu="--",Vr=typeof window<"u",ru=Vr?document:null,Ur=Vr?window:null,Nx=Vr?navigator:null,Lt,fl;function au(){let i=devicePixelRatio;Lt!=i&&(Lt=i,fl&&lu(qf,fl,au),fl=matchMedia(`(min-resolution: ${Lt-.001}dppx) and (max-resolution: ${Lt+.001}dppx)`),ar(qf,fl,au),Ur.dispatchEvent(new CustomEvent(xl)))}function ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function ou(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Mi(i,e,t,n){let s=ru.createElement(i);return e!=null&&ei(s,e),t?.insertBefore(s,n),s}function fi(i,e){return Mi("div",i,e)}var Yf=new WeakMap;function Wi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=Yf.get(i);r!=a&&(i.style.transform=r,Yf.set(i,r),e<0||t<0||e>n||t>s?ei(i,rr):ou(i,rr))}var $f=new WeakMap;function Zf(i,e,t){let n=e+t,s=$f.get(i);n!=s&&($f.set(i,n),i.style.background=e,i.style.borderColor=t)}var Jf=new WeakMap;function Kf(i,e,t,n){let s=e+""+t,r=Jf.get(i);s!=r&&(Jf.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var xu={passive:!0},Fx={...xu,capture:!0};function ar(i,e,t,n){e.addEventListener(i,t,n?Fx:xu)}function lu(i,e,t,n){e.removeEventListener(i,t,xu)}Vr&&au();function Si(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ti((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Tp(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var Ap=i=>i!=null,Ep=i=>i!=null&&i>0,yl=Tp(Ap),Ux=Tp(Ep);function Ox(i,e,t,n=0,s=!1){let r=s?Ux:yl,a=s?Ep:Ap;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??Vt,l??-Vt]}function bl(i,e,t,n){let s=ep(i),r=ep(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?as:Cp,o=s==1?ti:pi,l=r==1?pi:ti,c=o(a(pn(i))),h=l(a(pn(e))),u=Or(t,c),d=Or(t,h);return t==10&&(c<0&&(u=Gt(u,-c)),h<0&&(d=Gt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Lp(i,u),e=Ml(e,d)),[i,e]}function _u(i,e,t,n){let s=bl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var vu=.1,Qf={mode:3,pad:vu},Va={pad:0,soft:null,mode:0},Bx={min:Va,max:Va};function _l(i,e,t,n){return Sl(t)?jf(i,e,t):(Va.pad=t,Va.soft=n?0:null,Va.mode=n?3:0,jf(i,e,Bx))}function Pt(i,e){return i??e}function kx(i,e,t){for(e=Pt(e,0),t=Pt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function jf(i,e,t){let n=t.min,s=t.max,r=Pt(n.pad,0),a=Pt(s.pad,0),o=Pt(n.hard,-Vt),l=Pt(s.hard,Vt),c=Pt(n.soft,Vt),h=Pt(s.soft,-Vt),u=Pt(n.mode,0),d=Pt(s.mode,0),f=e-i,p=as(f),v=kn(pn(i),pn(e)),m=as(v),g=pn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Vt&&(r=0),d==2&&h!=-Vt&&(a=0)));let y=f||v||1e3,A=as(y),b=Or(10,ti(A)),C=y*(f==0?i==0?.1:1:r),E=Gt(Lp(i-C,b/10),24),x=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Vt,w=kn(o,E<x&&i>=x?x:wi(x,E)),O=y*(f==0?e==0?.1:1:a),L=Gt(Ml(e+O,b/10),24),I=e<=h&&(d==1||d==3&&L>=h||d==2&&L<=h)?h:-Vt,k=wi(l,L>I&&e<=I?I:kn(I,L));return w==k&&w==0&&(k=100),[w,k]}var zx=new Intl.NumberFormat(Vr?Nx.language:"en-US"),yu=i=>zx.format(i),ni=Math,gl=ni.PI,pn=ni.abs,ti=ni.floor,fn=ni.round,pi=ni.ceil,wi=ni.min,kn=ni.max,Or=ni.pow,ep=ni.sign,as=ni.log10,Cp=ni.log2,Vx=(i,e=1)=>ni.sinh(i)*e,tu=(i,e=1)=>ni.asinh(i/e),Vt=1/0;function tp(i){return(as((i^i>>31)-(i>>31))|0)+1}function cu(i,e,t){return wi(kn(i,e),t)}function Rp(i){return typeof i=="function"}function Tt(i){return Rp(i)?i:()=>i}var Gx=()=>{},Pp=i=>i,Ip=(i,e)=>e,Hx=i=>null,np=i=>!0,ip=(i,e)=>i==e,Wx=/\.\d*?(?=9{6,}|0{6,})/gm,or=i=>{if(Np(i)||Ds.has(i))return i;let e=`${i}`,t=e.match(Wx);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${or(s)}e${r}`}return Gt(i,n)};function ir(i,e){return or(Gt(or(i/e))*e)}function Ml(i,e){return or(pi(or(i/e))*e)}function Lp(i,e){return or(ti(or(i/e))*e)}function Gt(i,e=0){if(Np(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return fn(n)/t}var Ds=new Map;function Dp(i){return((""+i).split(".")[1]||"").length}function Ha(i,e,t,n){let s=[],r=n.map(Dp);for(let a=e;a<t;a++){let o=pn(a),l=Gt(Or(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,u=(a>=0?0:o)+(a>=r[c]?0:r[c]),d=i==10?h:Gt(h,u);s.push(d),Ds.set(d,u)}}return s}var Ga={},bu=[],Br=[null,null],Ls=Array.isArray,Np=Number.isInteger,Xx=i=>i===void 0;function sp(i){return typeof i=="string"}function Sl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function qx(i){return i!=null&&typeof i=="object"}var Yx=Object.getPrototypeOf(Uint8Array),Fp="__proto__";function kr(i,e=Sl){let t;if(Ls(i)){let n=i.find(s=>s!=null);if(Ls(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=kr(i[s],e)}else t=i.slice()}else if(i instanceof Yx)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Fp&&(t[n]=kr(i[n],e))}else t=i;return t}function hn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Fp&&(Sl(i[s])?hn(i[s],kr(n[s])):i[s]=kr(n[s]))}return i}var $x=0,Zx=1,Jx=2;function Kx(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Qx(i,e){if(t_(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return n_(a[0])||(a=e_(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],u=Array(s).fill(void 0),d=e?e[a][c]:Zx,f=[];for(let p=0;p<h.length;p++){let v=h[p],m=r.get(l[p]);v===null?d!=$x&&(u[m]=v,d==Jx&&f.push(m)):u[m]=v}Kx(u,f,s),n.push(u)}}return n}var jx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function e_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function t_(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function n_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=kn(1,ti((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var Up=["January","February","March","April","May","June","July","August","September","October","November","December"],Op=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Bp(i){return i.slice(0,3)}var i_=Op.map(Bp),s_=Up.map(Bp),r_={MMMM:Up,MMM:s_,WWWW:Op,WWW:i_};function Oa(i){return(i<10?"0":"")+i}function a_(i){return(i<10?"00":i<100?"0":"")+i}var o_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Oa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Oa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Oa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Oa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Oa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>a_(i.getMilliseconds())};function Mu(i,e){e=e||r_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?o_[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var l_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function c_(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==l_?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var kp=i=>i%1==0,vl=[1,2,2.5,5],h_=Ha(10,-32,0,vl),zp=Ha(10,0,32,vl),u_=zp.filter(kp),sr=h_.concat(zp),Su=`
`,Vp="{YYYY}",rp=Su+Vp,Gp="{M}/{D}",za=Su+Gp,pl=za+"/{YY}",Hp="{aa}",d_="{h}:{mm}",Fr=d_+Hp,ap=Su+Fr,op=":{ss}",Nt=null;function Wp(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?Ha(10,0,3,vl).filter(kp):Ha(10,-3,0,vl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,Vp,Nt,Nt,Nt,Nt,Nt,Nt,1],[s*28,"{MMM}",rp,Nt,Nt,Nt,Nt,Nt,1],[s,Gp,rp,Nt,Nt,Nt,Nt,Nt,1],[n,"{h}"+Hp,pl,Nt,za,Nt,Nt,Nt,1],[t,Fr,pl,Nt,za,Nt,Nt,Nt,1],[e,op,pl+" "+Fr,Nt,za+" "+Fr,Nt,ap,Nt,1],[i,op+".{fff}",pl+" "+Fr,Nt,za+" "+Fr,Nt,ap,Nt,1]];function h(u){return(d,f,p,v,m,g)=>{let y=[],A=m>=a,b=m>=r&&m<a,C=u(p),E=Gt(C*i,3),x=nu(C.getFullYear(),A?0:C.getMonth(),b||A?1:C.getDate()),w=Gt(x*i,3);if(b||A){let O=b?m/r:0,L=A?m/a:0,I=E==w?E:Gt(nu(x.getFullYear()+L,x.getMonth()+O,1)*i,3),k=new Date(fn(I/i)),H=k.getFullYear(),D=k.getMonth();for(let V=0;I<=v;V++){let q=nu(H+L*V,D+O*V,1),z=q-u(Gt(q*i,3));I=Gt((+q+z)*i,3),I<=v&&y.push(I)}}else{let O=m>=s?s:m,L=ti(p)-ti(E),I=w+L+Ml(E-w,O);y.push(I);let k=u(I),H=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,D=m/n,V=d.axes[f]._space,q=g/V;for(;I=Gt(I+m,i==1?0:3),!(I>v);)if(D>1){let z=ti(Gt(H+D,6))%24,Q=u(I).getHours()-z;Q>1&&(Q=-1),I-=Q*n,H=(H+D)%24;let ee=y[y.length-1];Gt((I-ee)/m,3)*q>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,h]}var[f_,p_,m_]=Wp(1),[g_,x_,__]=Wp(.001);Ha(2,-53,53,[1]);function lp(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function cp(i,e){return(t,n,s,r,a)=>{let o=e.find(p=>a>=p[0])||e[e.length-1],l,c,h,u,d,f;return n.map(p=>{let v=i(p),m=v.getFullYear(),g=v.getMonth(),y=v.getDate(),A=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),E=m!=l&&o[2]||g!=c&&o[3]||y!=h&&o[4]||A!=u&&o[5]||b!=d&&o[6]||C!=f&&o[7]||o[1];return l=m,c=g,h=y,u=A,d=b,f=C,E(v)})}}function v_(i,e){let t=Mu(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function nu(i,e,t){return new Date(i,e,t)}function hp(i,e){return e(i)}var y_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function up(i,e){return(t,n,s,r)=>r==null?gu:e(i(n))}function b_(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function M_(i,e){return i.series[e].fill(i,e)}var S_={show:!0,live:!0,isolate:!1,mount:Gx,markers:{show:!0,width:2,stroke:b_,fill:M_,dash:"solid"},idx:null,idxs:null,values:[]};function w_(i,e){let t=i.cursor.points,n=fi(),s=t.size(i,e);Yt(n,Ba,s),Yt(n,ka,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Yt(n,"borderWidth",a),n}function T_(i,e){let t=i.series[e].points;return t._fill||t._stroke}function A_(i,e){let t=i.series[e].points;return t._stroke||t._fill}function E_(i,e){return i.series[e].points.size}var iu=[0,0];function C_(i,e,t){return iu[0]=e,iu[1]=t,iu}function ml(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function su(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var R_={show:!0,x:!0,y:!0,lock:!1,move:C_,points:{one:!1,show:w_,size:E_,width:0,stroke:A_,fill:T_},bind:{mousedown:ml,mouseup:ml,click:ml,dblclick:ml,mousemove:su,mouseleave:su,mouseenter:su},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Xp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},wu=hn({},Xp,{filter:Ip}),qp=hn({},wu,{size:10}),Yp=hn({},Xp,{show:!1}),Tu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',$p="bold "+Tu,Zp=1.5,dp={show:!0,scale:"x",stroke:mu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:$p,side:2,grid:wu,ticks:qp,border:Yp,font:Tu,lineGap:Zp,rotate:0},P_="Value",I_="Time",fp={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function L_(i,e,t,n,s){return e.map(r=>r==null?"":yu(r))}function D_(i,e,t,n,s,r,a){let o=[],l=Ds.get(s)||0;t=a?t:Gt(Ml(t,s),l);for(let c=t;c<=n;c=Gt(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function hu(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?as:Cp,h=ti(c(t));s=Or(l,h),l==10&&(s=sr[Si(s,sr)]);let u=t,d=s*l;l==10&&(d=sr[Si(d,sr)]);do o.push(u),u=u+s,l==10&&!Ds.has(u)&&(u=Gt(u,Ds.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=sr[Si(d,sr)]));while(u<=n);return o}function N_(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?hu(i,e,kn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?hu(i,e,kn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Jp=/./,F_=/[12357]/,U_=/[125]/,pp=/1/,uu=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function O_(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),u=l(9,a)-h>=c?Jp:l(7,a)-h>=c?F_:l(5,a)-h>=c?U_:pp;if(u==pp){let d=pn(l(1,a)-h);if(d<c)return uu(e.slice().reverse(),o.distr,u,pi(c/d)).reverse()}return uu(e,o.distr,u,1)}function B_(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=pn(l(1,a)-l(2,a));return c<o?uu(e.slice().reverse(),3,Jp,pi(o/c)).reverse():e}function k_(i,e,t,n){return n==null?gu:e==null?"":yu(e)}var mp={show:!0,scale:"y",stroke:mu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:$p,side:3,grid:wu,ticks:qp,border:Yp,font:Tu,lineGap:Zp,rotate:0};function z_(i,e){let t=3+(i||1)*2;return Gt(t*e,3)}function V_(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=pn(a-r),l=i.series[e],c=o/(l.points.space*Lt);return n[1]-n[0]<=c}var gp={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},Kp=(i,e,t,n,s)=>s,xp={show:!0,auto:!0,sorted:0,gaps:Kp,alpha:1,facets:[hn({},gp,{scale:"x"}),hn({},gp,{scale:"y"})]},_p={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Kp,alpha:1,points:{show:V_,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function G_(i,e,t,n,s){return t/10}var Qp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},H_=hn({},Qp,{time:!1,ori:1}),vp={};function jp(i,e){let t=vp[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(vp[i]=t)),t}var zr=1,du=2;function lr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],u=n==2?a[s.facets[1].scale]:a[s.scale],d=o.left,f=o.top,p=o.width,v=o.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,g,d,f,p,v,Tl,Gr,El,tm,im):t(s,l,c,h,u,g,m,f,d,v,p,Al,Hr,Cu,nm,sm)}function Au(i,e){let t=0,n=0,s=Pt(i.bands,bu);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function W_(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function os(i,e,t,n,s,r){return lr(i,e,(a,o,l,c,h,u,d,f,p,v,m)=>{let g=a.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?Gr:Hr,b,C;y==1?(b=t,C=n):(b=n,C=t);let E=g(u(o[b],c,v,f)),x=g(d(l[b],h,m,p)),w=g(u(o[C],c,v,f)),O=g(d(r==1?h.max:h.min,h,m,p)),L=new Path2D(s);return A(L,w,O),A(L,E,O),A(L,E,x),L})}function wl(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?El:Cu,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&o(a,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function X_(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Eu(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),v=u-s;f=a<=0&&v>=0&&v<l?r(i[v]):f;let g=d+s;p=a>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&o.push([f,p])}return o}function yp(i){return i==0?Pp:i==1?fn:e=>ir(e,i)}function em(i){let e=i==0?Tl:Al,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=wi(c,o/2,l/2),h=wi(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var Tl=(i,e,t)=>{i.moveTo(e,t)},Al=(i,e,t)=>{i.moveTo(t,e)},Gr=(i,e,t)=>{i.lineTo(e,t)},Hr=(i,e,t)=>{i.lineTo(t,e)},El=em(0),Cu=em(1),tm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},nm=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},im=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},sm=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function rm(i){return(e,t,n,s,r)=>lr(e,t,(a,o,l,c,h,u,d,f,p,v,m)=>{let{pxRound:g,points:y}=a,A,b;c.ori==0?(A=Tl,b=tm):(A=Al,b=nm);let C=Gt(y.width*Lt,3),E=(y.size-y.width)/2*Lt,x=Gt(E*2,3),w=new Path2D,O=new Path2D,{left:L,top:I,width:k,height:H}=e.bbox;El(O,L-x,I-x,k+x*2,H+x*2);let D=V=>{if(l[V]!=null){let q=g(u(o[V],c,v,f)),z=g(d(l[V],h,m,p));A(w,q+E,z),b(w,q,z,E,0,gl*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:C>0?w:null,fill:w,clip:O,flags:zr|du}})}function am(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var q_=am(Gr),Y_=am(Hr);function om(i){let e=Pt(i?.alignGaps,0);return(t,n,s,r)=>lr(t,n,(a,o,l,c,h,u,d,f,p,v,m)=>{[s,r]=yl(l,s,r);let g=a.pxRound,y=H=>g(u(H,c,v,f)),A=H=>g(d(H,h,m,p)),b,C;c.ori==0?(b=Gr,C=q_):(b=Hr,C=Y_);let E=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},w=x.stroke,O=!1;if(r-s>=v*4){let H=ce=>t.posToVal(ce,c.key,!0),D=null,V=null,q,z,le,Z=y(o[E==1?s:r]),Q=y(o[s]),ee=y(o[r]),de=H(E==1?Q+1:ee-1);for(let ce=E==1?s:r;ce>=s&&ce<=r;ce+=E){let j=o[ce],_e=(E==1?j<de:j>de)?Z:y(j),Le=l[ce];_e==Z?Le!=null?(z=Le,D==null?(b(w,_e,A(z)),q=D=V=z):z<D?D=z:z>V&&(V=z)):Le===null&&(O=!0):(D!=null&&C(w,Z,A(D),A(V),A(q),A(z)),Le!=null?(z=Le,b(w,_e,A(z)),D=V=q=z):(D=V=null,Le===null&&(O=!0)),Z=_e,de=H(Z+E))}D!=null&&D!=V&&le!=Z&&C(w,Z,A(D),A(V),A(q),A(z))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let D=l[H];D===null?O=!0:D!=null&&b(w,y(o[H]),A(D))}let[I,k]=Au(t,n);if(a.fill!=null||I!=0){let H=x.fill=new Path2D(w),D=a.fillTo(t,n,a.min,a.max,I),V=A(D),q=y(o[s]),z=y(o[r]);E==-1&&([z,q]=[q,z]),b(H,z,V),b(H,q,V)}if(!a.spanGaps){let H=[];O&&H.push(...Eu(o,l,s,r,E,y,e)),x.gaps=H=a.gaps(t,n,s,r,H),x.clip=wl(H,c.ori,f,p,v,m)}return k!=0&&(x.band=k==2?[os(t,n,s,r,w,-1),os(t,n,s,r,w,1)]:os(t,n,s,r,w,k)),x})}function $_(i){let e=Pt(i.align,1),t=Pt(i.ascDesc,!1),n=Pt(i.alignGaps,0),s=Pt(i.extend,!1);return(r,a,o,l)=>lr(r,a,(c,h,u,d,f,p,v,m,g,y,A)=>{[o,l]=yl(u,o,l);let b=c.pxRound,{left:C,width:E}=r.bbox,x=Q=>b(p(Q,d,y,m)),w=Q=>b(v(Q,f,A,g)),O=d.ori==0?Gr:Hr,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},I=L.stroke,k=d.dir*(d.ori==0?1:-1),H=w(u[k==1?o:l]),D=x(h[k==1?o:l]),V=D,q=D;s&&e==-1&&(q=C,O(I,q,H)),O(I,D,H);for(let Q=k==1?o:l;Q>=o&&Q<=l;Q+=k){let ee=u[Q];if(ee==null)continue;let de=x(h[Q]),ce=w(ee);e==1?O(I,de,H):O(I,V,ce),O(I,de,ce),H=ce,V=de}let z=V;s&&e==1&&(z=C+E,O(I,z,H));let[le,Z]=Au(r,a);if(c.fill!=null||le!=0){let Q=L.fill=new Path2D(I),ee=c.fillTo(r,a,c.min,c.max,le),de=w(ee);O(Q,z,de),O(Q,q,de)}if(!c.spanGaps){let Q=[];Q.push(...Eu(h,u,o,l,k,x,n));let ee=c.width*Lt/2,de=t||e==1?ee:-ee,ce=t||e==-1?-ee:ee;Q.forEach(j=>{j[0]+=de,j[1]+=ce}),L.gaps=Q=c.gaps(r,a,o,l,Q),L.clip=wl(Q,d.ori,m,g,y,A)}return Z!=0&&(L.band=Z==2?[os(r,a,o,l,I,-1),os(r,a,o,l,I,1)]:os(r,a,o,l,I,Z)),L})}function bp(i,e,t,n,s,r,a=Vt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let h=pn(i[l]-i[o]);h<c&&(c=h,a=pn(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function Z_(i){i=i||Ga;let e=Pt(i.size,[.6,Vt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Tt(s),a=1-e[0],o=Pt(e[1],Vt),l=Pt(e[2],1),c=Pt(i.disp,Ga),h=Pt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,v,m)=>lr(f,p,(g,y,A,b,C,E,x,w,O,L,I)=>{let k=g.pxRound,H=t,D=n*Lt,V=o*Lt,q=l*Lt,z,le;b.ori==0?[z,le]=r(f,p):[le,z]=r(f,p);let Z=b.dir*(b.ori==0?1:-1),Q=b.ori==0?El:Cu,ee=b.ori==0?h:(be,Xe,ct,we,Dt,$e,je)=>{h(be,Xe,ct,Dt,we,je,$e)},de=Pt(f.bands,bu).find(be=>be.series[0]==p),ce=de!=null?de.dir:0,j=g.fillTo(f,p,g.min,g.max,ce),ge=k(x(j,C,I,O)),_e,Le,Se,Ge=L,it=k(g.width*Lt),Je=!1,st=null,tt=null,re=null,ve=null;u!=null&&(it==0||d!=null)&&(Je=!0,st=u.values(f,p,v,m),tt=new Map,new Set(st).forEach(be=>{be!=null&&tt.set(be,new Path2D)}),it>0&&(re=d.values(f,p,v,m),ve=new Map,new Set(re).forEach(be=>{be!=null&&ve.set(be,new Path2D)})));let{x0:xe,size:Be}=c;if(xe!=null&&Be!=null){H=1,y=xe.values(f,p,v,m),xe.unit==2&&(y=y.map(ct=>f.posToVal(w+ct*L,b.key,!0)));let be=Be.values(f,p,v,m);Be.unit==2?Le=be[0]*L:Le=E(be[0],b,L,w)-E(0,b,L,w),Ge=bp(y,A,E,b,L,w,Ge),Se=Ge-Le+D}else Ge=bp(y,A,E,b,L,w,Ge),Se=Ge*a+D,Le=Ge-Se;Se<1&&(Se=0),it>=Le/2&&(it=0),Se<5&&(k=Pp);let De=Se>0,et=Ge-Se-(De?it:0);Le=k(cu(et,q,V)),_e=(H==0?Le/2:H==Z?0:Le)-H*Z*((H==0?D/2:0)+(De?it/2:0));let ke={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pt=Je?null:new Path2D,ut=null;if(de!=null)ut=f.data[de.series[1]];else{let{y0:be,y1:Xe}=c;be!=null&&Xe!=null&&(A=Xe.values(f,p,v,m),ut=be.values(f,p,v,m))}let xt=z*Le,F=le*Le;for(let be=Z==1?v:m;be>=v&&be<=m;be+=Z){let Xe=A[be];if(Xe==null)continue;if(ut!=null){let X=ut[be]??0;if(Xe-X==0)continue;ge=x(X,C,I,O)}let ct=b.distr!=2||c!=null?y[be]:be,we=E(ct,b,L,w),Dt=x(Pt(Xe,j),C,I,O),$e=k(we-_e),je=k(kn(Dt,ge)),R=k(wi(Dt,ge)),M=je-R;if(Xe!=null){let X=Xe<0?F:xt,ue=Xe<0?xt:F;Je?(it>0&&re[be]!=null&&Q(ve.get(re[be]),$e,R+ti(it/2),Le,kn(0,M-it),X,ue),st[be]!=null&&Q(tt.get(st[be]),$e,R+ti(it/2),Le,kn(0,M-it),X,ue)):Q(pt,$e,R+ti(it/2),Le,kn(0,M-it),X,ue),ee(f,p,be,$e-it/2,R,Le+it,M)}}return it>0?ke.stroke=Je?ve:pt:Je||(ke._fill=g.width==0?g._fill:g._stroke??g._fill,ke.width=0),ke.fill=Je?tt:pt,ke})}function J_(i,e){let t=Pt(e?.alignGaps,0);return(n,s,r,a)=>lr(n,s,(o,l,c,h,u,d,f,p,v,m,g)=>{[r,a]=yl(c,r,a);let y=o.pxRound,A=z=>y(d(z,h,m,p)),b=z=>y(f(z,u,g,v)),C,E,x;h.ori==0?(C=Tl,x=Gr,E=im):(C=Al,x=Hr,E=sm);let w=h.dir*(h.ori==0?1:-1),O=A(l[w==1?r:a]),L=O,I=[],k=[];for(let z=w==1?r:a;z>=r&&z<=a;z+=w)if(c[z]!=null){let Z=l[z],Q=A(Z);I.push(L=Q),k.push(b(c[z]))}let H={stroke:i(I,k,C,x,E,y),fill:null,clip:null,band:null,gaps:null,flags:zr},D=H.stroke,[V,q]=Au(n,s);if(o.fill!=null||V!=0){let z=H.fill=new Path2D(D),le=o.fillTo(n,s,o.min,o.max,V),Z=b(le);x(z,L,Z),x(z,O,Z)}if(!o.spanGaps){let z=[];z.push(...Eu(l,c,r,a,w,A,t)),H.gaps=z=o.gaps(n,s,r,a,z),H.clip=wl(z,h.ori,p,v,m,g)}return q!=0&&(H.band=q==2?[os(n,s,r,a,D,-1),os(n,s,r,a,D,1)]:os(n,s,r,a,D,q)),H})}function K_(i){return J_(Q_,i)}function Q_(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),u=Array(a-1);for(let d=0;d<a-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<a-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[a-1]=c[a-2];for(let d=0;d<a-1;d++)s(o,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return o}var fu=new Set;function Mp(){for(let i of fu)i.syncRect(!0)}Vr&&(ar(Lx,Ur,Mp),ar(Dx,Ur,Mp,!0),ar(xl,Ur,()=>{An.pxRatio=Lt}));var j_=om(),ev=rm();function Sp(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>pu(r,a,e,t))}function tv(i,e){return i.map((t,n)=>n==0?{}:hn({},e,t))}function pu(i,e,t,n){return hn({},e==0?t:n,i)}function lm(i,e,t){return e==null?Br:[e,t]}var nv=lm;function iv(i,e,t){return e==null?Br:_l(e,t,vu,!0)}function cm(i,e,t,n){return e==null?Br:bl(e,t,i.scales[n].log,!1)}var sv=cm;function hm(i,e,t,n){return e==null?Br:_u(e,t,i.scales[n].log,!1)}var rv=hm;function av(i,e,t,n,s){let r=kn(tp(i),tp(e)),a=e-i,o=Si(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?Ds.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function wp(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=fn((t=+s)*Lt))+"px"),[i,e,t]}function ov(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Gt(e[2]*Lt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function An(i,e,t){let n={mode:Pt(i.mode,1)},s=n.mode;function r(_,S,P,N){let G=S.valToPct(_);return N+P*(S.dir==-1?1-G:G)}function a(_,S,P,N){let G=S.valToPct(_);return N+P*(S.dir==-1?G:1-G)}function o(_,S,P,N){return S.ori==0?r(_,S,P,N):a(_,S,P,N)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=fi(px);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let _=fi(xx,c);_.textContent=i.title}let h=Mi("canvas"),u=n.ctx=h.getContext("2d"),d=fi(_x,c);ar("click",d,_=>{_.target===p&&(Wt!=Er||Zt!=Cr)&&wn.click(n,_)},!0);let f=n.under=fi(vx,d);d.appendChild(h);let p=n.over=fi(yx,d);i=kr(i);let v=+Pt(i.pxAlign,1),m=yp(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let g=i.ms||.001,y=n.series=s==1?Sp(i.series||[],fp,_p,!1):tv(i.series||[null],xp),A=n.axes=Sp(i.axes||[],dp,mp,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(_=>{_.fill=Tt(_.fill||null),_.dir=Pt(_.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,x={axes:ns,series:bt},w=(i.drawOrder||["axes","series"]).map(_=>x[_]);function O(_){let S=_.distr==3?P=>as(P>0?P:_.clamp(n,P,_.min,_.max,_.key)):_.distr==4?P=>tu(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=S(P),{_min:G,_max:J}=_,oe=J-G;return(N-G)/oe}}function L(_){let S=b[_];if(S==null){let P=(i.scales||Ga)[_]||Ga;if(P.from!=null){L(P.from);let N=hn({},b[P.from],P,{key:_});N.valToPct=O(N),b[_]=N}else{S=b[_]=hn({},_==E?Qp:H_,P),S.key=_;let N=S.time,G=S.range,J=Ls(G);if((_!=E||s==2&&!N)&&(J&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?Qf:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?Qf:{mode:1,hard:G[1],soft:G[1]}},J=!1),!J&&Sl(G))){let oe=G;G=(pe,Ae,ze)=>Ae==null?Br:_l(Ae,ze,oe)}S.range=Tt(G||(N?nv:_==E?S.distr==3?sv:S.distr==4?rv:lm:S.distr==3?cm:S.distr==4?hm:iv)),S.auto=Tt(J?!1:S.auto),S.clamp=Tt(S.clamp||G_),S._min=S._max=null,S.valToPct=O(S)}}}L("x"),L("y"),s==1&&y.forEach(_=>{L(_.scale)}),A.forEach(_=>{L(_.scale)});for(let _ in i.scales)L(_);let I=b[E],k=I.distr,H,D;I.ori==0?(ei(c,mx),H=r,D=a):(ei(c,gx),H=a,D=r);let V={};for(let _ in b){let S=b[_];(S.min!=null||S.max!=null)&&(V[_]={min:S.min,max:S.max},S.min=S.max=null)}let q=i.tzDate||(_=>new Date(fn(_/g))),z=i.fmtDate||Mu,le=g==1?m_(q):__(q),Z=cp(q,lp(g==1?p_:x_,z)),Q=up(q,hp(y_,z)),ee=[],de=n.legend=hn({},S_,i.legend),ce=n.cursor=hn({},R_,{drag:{y:s==2}},i.cursor),j=de.show,ge=ce.show,_e=de.markers;de.idxs=ee,_e.width=Tt(_e.width),_e.dash=Tt(_e.dash),_e.stroke=Tt(_e.stroke),_e.fill=Tt(_e.fill);let Le,Se,Ge,it=[],Je=[],st,tt=!1,re={};if(de.live){let _=y[1]?y[1].values:null;tt=_!=null,st=tt?_(n,1,0):{_:0};for(let S in st)re[S]=gu}if(j)if(Le=Mi("table",Ax,c),Ge=Mi("tbody",null,Le),de.mount(n,Le),tt){Se=Mi("thead",null,Le,Ge);let _=Mi("tr",null,Se);Mi("th",null,_);for(var ve in st)Mi("th",kf,_).textContent=ve}else ei(Le,Cx),de.live&&ei(Le,Ex);let xe={show:!0},Be={show:!1};function De(_,S){if(S==0&&(tt||!de.live||s==2))return Br;let P=[],N=Mi("tr",Rx,Ge,Ge.childNodes[S]);ei(N,_.class),_.show||ei(N,rr);let G=Mi("th",null,N);if(_e.show){let pe=fi(Px,G);if(S>0){let Ae=_e.width(n,S);Ae&&(pe.style.border=Ae+"px "+_e.dash(n,S)+" "+_e.stroke(n,S)),pe.style.background=_e.fill(n,S)}}let J=fi(kf,G);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,S>0&&(_e.show||(J.style.color=_.width>0?_e.stroke(n,S):_e.fill(n,S)),ke("click",G,pe=>{if(ce._lock)return;at(pe);let Ae=y.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let ze=y.some((Ve,We)=>We>0&&We!=Ae&&Ve.show);y.forEach((Ve,We)=>{We>0&&ki(We,ze?We==Ae?xe:Be:xe,!0,cn.setSeries)})}else ki(Ae,{show:!_.show},!0,cn.setSeries)},!1),ot&&ke(Hf,G,pe=>{ce._lock||(at(pe),ki(y.indexOf(_),Pr,!0,cn.setSeries))},!1));for(var oe in st){let pe=Mi("td",Ix,N);pe.textContent="--",P.push(pe)}return[N,P]}let et=new Map;function ke(_,S,P,N=!0){let G=et.get(S)||{},J=ce.bind[_](n,S,P,N);J&&(ar(_,S,G[_]=J),et.set(S,G))}function pt(_,S,P){let N=et.get(S)||{};for(let G in N)(_==null||G==_)&&(lu(G,S,N[G]),delete N[G]);_==null&&et.delete(S)}let ut=0,xt=0,F=0,be=0,Xe=0,ct=0,we=Xe,Dt=ct,$e=F,je=be,R=0,M=0,X=0,ue=0;n.bbox={};let ae=!1,Me=!1,Te=!1,te=!1,ie=!1,me=!1;function U(_,S,P){(P||_!=n.width||S!=n.height)&&se(_,S),_t(!1),Te=!0,Me=!0,Cn()}function se(_,S){n.width=ut=F=_,n.height=xt=be=S,Xe=ct=0,Ce(),Ke();let P=n.bbox;R=P.left=ir(Xe*Lt,.5),M=P.top=ir(ct*Lt,.5),X=P.width=ir(F*Lt,.5),ue=P.height=ir(be*Lt,.5)}let ne=3;function Re(){let _=!1,S=0;for(;!_;){S++;let P=wr(S),N=Bi(S);_=S==ne||P&&N,_||(se(n.width,n.height),Me=!0)}}function ye({width:_,height:S}){U(_,S)}n.setSize=ye;function Ce(){let _=!1,S=!1,P=!1,N=!1;A.forEach((G,J)=>{if(G.show&&G._show){let{side:oe,_size:pe}=G,Ae=oe%2,ze=G.label!=null?G.labelSize:0,Ve=pe+ze;Ve>0&&(Ae?(F-=Ve,oe==3?(Xe+=Ve,N=!0):P=!0):(be-=Ve,oe==0?(ct+=Ve,_=!0):S=!0))}}),Ui[0]=_,Ui[1]=P,Ui[2]=S,Ui[3]=N,F-=_i[1]+_i[3],Xe+=_i[3],be-=_i[2]+_i[0],ct+=_i[0]}function Ke(){let _=Xe+F,S=ct+be,P=Xe,N=ct;function G(J,oe){switch(J){case 1:return _+=oe,_-oe;case 2:return S+=oe,S-oe;case 3:return P-=oe,P+oe;case 0:return N-=oe,N+oe}}A.forEach((J,oe)=>{if(J.show&&J._show){let pe=J.side;J._pos=G(pe,J._size),J.label!=null&&(J._lpos=G(pe,J.labelSize))}})}if(ce.dataIdx==null){let _=ce.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let P=_.prox=Tt(_.prox),N=_.bias??=0;ce.dataIdx=(G,J,oe,pe)=>{if(J==0)return oe;let Ae=oe,ze=P(G,J,oe,pe)??Vt,Ve=ze>=0&&ze<Vt,We=I.ori==0?F:be,ft=ce.left,It=e[0],Rt=e[J];if(S.has(Rt[oe])){Ae=null;let Mt=null,rt=null,Qe;if(N==0||N==-1)for(Qe=oe;Mt==null&&Qe-- >0;)S.has(Rt[Qe])||(Mt=Qe);if(N==0||N==1)for(Qe=oe;rt==null&&Qe++<Rt.length;)S.has(Rt[Qe])||(rt=Qe);if(Mt!=null||rt!=null)if(Ve){let qt=Mt==null?-1/0:H(It[Mt],I,We,0),tn=rt==null?1/0:H(It[rt],I,We,0),yn=ft-qt,zt=tn-ft;yn<=zt?yn<=ze&&(Ae=Mt):zt<=ze&&(Ae=rt)}else Ae=rt==null?Mt:Mt==null?rt:oe-Mt<=rt-oe?Mt:rt}else Ve&&pn(ft-H(It[oe],I,We,0))>ze&&(Ae=null);return Ae}}let at=_=>{ce.event=_};ce.idxs=ee,ce._lock=!1;let he=ce.points;he.show=Tt(he.show),he.size=Tt(he.size),he.stroke=Tt(he.stroke),he.width=Tt(he.width),he.fill=Tt(he.fill);let qe=n.focus=hn({},i.focus||{alpha:.3},ce.focus),ot=qe.prox>=0,Ne=ot&&he.one,gt=[],Ht=[],Nn=[];function Aa(_,S){let P=he.show(n,S);if(P instanceof HTMLElement)return ei(P,Tx),ei(P,_.class),Wi(P,-10,-10,F,be),p.insertBefore(P,gt[S]),P}function br(_,S){if(s==1||S>0){let P=s==1&&b[_.scale].time,N=_.value;_.value=P?sp(N)?up(q,hp(N,z)):N||Q:N||k_,_.label=_.label||(P?I_:P_)}if(Ne||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||j_||Hx,_.fillTo=Tt(_.fillTo||W_),_.pxAlign=+Pt(_.pxAlign,v),_.pxRound=yp(_.pxAlign),_.stroke=Tt(_.stroke||null),_.fill=Tt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=z_(kn(1,_.width),1),N=_.points=hn({},{size:P,width:kn(1,P*.2),stroke:_.stroke,space:P*2,paths:ev,_stroke:null,_fill:null},_.points);N.show=Tt(N.show),N.filter=Tt(N.filter),N.fill=Tt(N.fill),N.stroke=Tt(N.stroke),N.paths=Tt(N.paths),N.pxAlign=_.pxAlign}if(j){let P=De(_,S);it.splice(S,0,P[0]),Je.splice(S,0,P[1]),de.values.push(null)}if(ge){ee.splice(S,0,null);let P=null;Ne?S==0&&(P=Aa(_,S)):S>0&&(P=Aa(_,S)),gt.splice(S,0,P),Ht.splice(S,0,0),Nn.splice(S,0,0)}vn("addSeries",S)}function Bh(_,S){S=S??y.length,_=s==1?pu(_,S,fp,_p):pu(_,S,{},xp),y.splice(S,0,_),br(y[S],S)}n.addSeries=Bh;function Yo(_){if(y.splice(_,1),j){de.values.splice(_,1),Je.splice(_,1);let S=it.splice(_,1)[0];pt(null,S.firstChild),S.remove()}ge&&(ee.splice(_,1),gt.splice(_,1)[0].remove(),Ht.splice(_,1),Nn.splice(_,1)),vn("delSeries",_)}n.delSeries=Yo;let Ui=[!1,!1,!1,!1];function ji(_,S){if(_._show=_.show,_.show){let P=_.side%2,N=b[_.scale];N==null&&(_.scale=P?y[1].scale:E,N=b[_.scale]);let G=N.time;_.size=Tt(_.size),_.space=Tt(_.space),_.rotate=Tt(_.rotate),Ls(_.incrs)&&_.incrs.forEach(oe=>{!Ds.has(oe)&&Ds.set(oe,Dp(oe))}),_.incrs=Tt(_.incrs||(N.distr==2?u_:G?g==1?f_:g_:sr)),_.splits=Tt(_.splits||(G&&N.distr==1?le:N.distr==3?hu:N.distr==4?N_:D_)),_.stroke=Tt(_.stroke),_.grid.stroke=Tt(_.grid.stroke),_.ticks.stroke=Tt(_.ticks.stroke),_.border.stroke=Tt(_.border.stroke);let J=_.values;_.values=Ls(J)&&!Ls(J[0])?Tt(J):G?Ls(J)?cp(q,lp(J,z)):sp(J)?v_(q,J):J||Z:J||L_,_.filter=Tt(_.filter||(N.distr>=3&&N.log==10?O_:N.distr==3&&N.log==2?B_:Ip)),_.font=wp(_.font),_.labelFont=wp(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Ui[S]=!0,_._el=fi(bx,d))}}function es(_,S,P,N){let[G,J,oe,pe]=P,Ae=S%2,ze=0;return Ae==0&&(pe||J)&&(ze=S==0&&!G||S==2&&!oe?fn(dp.size/3):0),Ae==1&&(G||oe)&&(ze=S==1&&!J||S==3&&!pe?fn(mp.size/2):0),ze}let Ea=n.padding=(i.padding||[es,es,es,es]).map(_=>Tt(Pt(_,es))),_i=n._padding=Ea.map((_,S)=>_(n,S,Ui,0)),jt,sn=null,rn=null,Oi=s==1?y[0].idxs:null,$n=null,Ss=!1;function Ca(_,S){if(e=_??[],n.data=n._data=e,s==2){jt=0;for(let P=1;P<y.length;P++)jt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),$n=e[0],jt=$n.length;let P=e;if(k==2){P=e.slice();let N=P[0]=Array(jt);for(let G=0;G<jt;G++)N[G]=G}n._data=e=P}if(_t(!0),vn("setData"),k==2&&(Te=!0),S!==!1){let P=I;P.auto(n,Ss)?Ra():As(E,P.min,P.max),te=te||ce.left>=0,me=!0,Cn()}}n.setData=Ca;function Ra(){Ss=!0;let _,S;s==1&&(jt>0?(sn=Oi[0]=0,rn=Oi[1]=jt-1,_=e[0][sn],S=e[0][rn],k==2?(_=sn,S=rn):_==S&&(k==3?[_,S]=bl(_,_,I.log,!1):k==4?[_,S]=_u(_,_,I.log,!1):I.time?S=_+fn(86400/g):[_,S]=_l(_,S,vu,!0))):(sn=Oi[0]=_=null,rn=Oi[1]=S=null)),As(E,_,S)}let Mr,ws,Sr,T,B,K,Y,$,Pe,Fe;function Ie(_,S,P,N,G,J){_??=Vf,P??=bu,N??="butt",G??=Vf,J??="round",_!=Mr&&(u.strokeStyle=Mr=_),G!=ws&&(u.fillStyle=ws=G),S!=Sr&&(u.lineWidth=Sr=S),J!=B&&(u.lineJoin=B=J),N!=K&&(u.lineCap=K=N),P!=T&&u.setLineDash(T=P)}function Ue(_,S,P,N){S!=ws&&(u.fillStyle=ws=S),_!=Y&&(u.font=Y=_),P!=$&&(u.textAlign=$=P),N!=Pe&&(u.textBaseline=Pe=N)}function Ze(_,S,P,N,G=0){if(N.length>0&&_.auto(n,Ss)&&(S==null||S.min==null)){let J=Pt(sn,0),oe=Pt(rn,N.length-1),pe=P.min==null?Ox(N,J,oe,G,_.distr==3):[P.min,P.max];_.min=wi(_.min,P.min=pe[0]),_.max=kn(_.max,P.max=pe[1])}}let ht={min:null,max:null};function yt(){for(let N in b){let G=b[N];V[N]==null&&(G.min==null||V[E]!=null&&G.auto(n,Ss))&&(V[N]=ht)}for(let N in b){let G=b[N];V[N]==null&&G.from!=null&&V[G.from]!=null&&(V[N]=ht)}V[E]!=null&&_t(!0);let _={};for(let N in V){let G=V[N];if(G!=null){let J=_[N]=kr(b[N],qx);if(G.min!=null)hn(J,G);else if(N!=E||s==2)if(jt==0&&J.from==null){let oe=J.range(n,null,null,N);J.min=oe[0],J.max=oe[1]}else J.min=Vt,J.max=-Vt}}if(jt>0){y.forEach((N,G)=>{if(s==1){let J=N.scale,oe=V[J];if(oe==null)return;let pe=_[J];if(G==0){let Ae=pe.range(n,pe.min,pe.max,J);pe.min=Ae[0],pe.max=Ae[1],sn=Si(pe.min,e[0]),rn=Si(pe.max,e[0]),rn-sn>1&&(e[0][sn]<pe.min&&sn++,e[0][rn]>pe.max&&rn--),N.min=$n[sn],N.max=$n[rn]}else N.show&&N.auto&&Ze(pe,oe,N,e[G],N.sorted);N.idxs[0]=sn,N.idxs[1]=rn}else if(G>0&&N.show&&N.auto){let[J,oe]=N.facets,pe=J.scale,Ae=oe.scale,[ze,Ve]=e[G],We=_[pe],ft=_[Ae];We!=null&&Ze(We,V[pe],J,ze,J.sorted),ft!=null&&Ze(ft,V[Ae],oe,Ve,oe.sorted),N.min=oe.min,N.max=oe.max}});for(let N in _){let G=_[N],J=V[N];if(G.from==null&&(J==null||J.min==null)){let oe=G.range(n,G.min==Vt?null:G.min,G.max==-Vt?null:G.max,N);G.min=oe[0],G.max=oe[1]}}}for(let N in _){let G=_[N];if(G.from!=null){let J=_[G.from];if(J.min==null)G.min=G.max=null;else{let oe=G.range(n,J.min,J.max,N);G.min=oe[0],G.max=oe[1]}}}let S={},P=!1;for(let N in _){let G=_[N],J=b[N];if(J.min!=G.min||J.max!=G.max){J.min=G.min,J.max=G.max;let oe=J.distr;J._min=oe==3?as(J.min):oe==4?tu(J.min,J.asinh):oe==100?J.fwd(J.min):J.min,J._max=oe==3?as(J.max):oe==4?tu(J.max,J.asinh):oe==100?J.fwd(J.max):J.max,S[N]=P=!0}}if(P){y.forEach((N,G)=>{s==2?G>0&&S.y&&(N._paths=null):S[N.scale]&&(N._paths=null)});for(let N in S)Te=!0,vn("setScale",N);ge&&ce.left>=0&&(te=me=!0)}for(let N in V)V[N]=null}function Ye(_){let S=cu(sn-1,0,jt-1),P=cu(rn+1,0,jt-1);for(;_[S]==null&&S>0;)S--;for(;_[P]==null&&P<jt-1;)P++;return[S,P]}function bt(){if(jt>0){let _=y.some(S=>S._focus)&&Fe!=qe.alpha;_&&(u.globalAlpha=Fe=qe.alpha),y.forEach((S,P)=>{if(P>0&&S.show&&(Kt(P,!1),Kt(P,!0),S._paths==null)){let N=Fe;Fe!=S.alpha&&(u.globalAlpha=Fe=S.alpha);let G=s==2?[0,e[P][0].length-1]:Ye(e[P]);S._paths=S.paths(n,P,G[0],G[1]),Fe!=N&&(u.globalAlpha=Fe=N)}}),y.forEach((S,P)=>{if(P>0&&S.show){let N=Fe;Fe!=S.alpha&&(u.globalAlpha=Fe=S.alpha),S._paths!=null&&Ot(P,!1);{let G=S._paths!=null?S._paths.gaps:null,J=S.points.show(n,P,sn,rn,G),oe=S.points.filter(n,P,J,G);(J||oe)&&(S.points._paths=S.points.paths(n,P,sn,rn,oe),Ot(P,!0))}Fe!=N&&(u.globalAlpha=Fe=N),vn("drawSeries",P)}}),_&&(u.globalAlpha=Fe=1)}}function Kt(_,S){let P=S?y[_].points:y[_];P._stroke=P.stroke(n,_),P._fill=P.fill(n,_)}function Ot(_,S){let P=S?y[_].points:y[_],{stroke:N,fill:G,clip:J,flags:oe,_stroke:pe=P._stroke,_fill:Ae=P._fill,_width:ze=P.width}=P._paths;ze=Gt(ze*Lt,3);let Ve=null,We=ze%2/2;S&&Ae==null&&(Ae=ze>0?"#fff":pe);let ft=P.pxAlign==1&&We>0;if(ft&&u.translate(We,We),!S){let It=R-ze/2,Rt=M-ze/2,Mt=X+ze,rt=ue+ze;Ve=new Path2D,Ve.rect(It,Rt,Mt,rt)}S?He(pe,ze,P.dash,P.cap,Ae,N,G,oe,J):Bt(_,pe,ze,P.dash,P.cap,Ae,N,G,oe,Ve,J),ft&&u.translate(-We,-We)}function Bt(_,S,P,N,G,J,oe,pe,Ae,ze,Ve){let We=!1;Ae!=0&&C.forEach((ft,It)=>{if(ft.series[0]==_){let Rt=y[ft.series[1]],Mt=e[ft.series[1]],rt=(Rt._paths||Ga).band;Ls(rt)&&(rt=ft.dir==1?rt[0]:rt[1]);let Qe,qt=null;Rt.show&&rt&&kx(Mt,sn,rn)?(qt=ft.fill(n,It)||J,Qe=Rt._paths.clip):rt=null,He(S,P,N,G,qt,oe,pe,Ae,ze,Ve,Qe,rt),We=!0}}),We||He(S,P,N,G,J,oe,pe,Ae,ze,Ve)}let dn=zr|du;function He(_,S,P,N,G,J,oe,pe,Ae,ze,Ve,We){Ie(_,S,P,N,G),(Ae||ze||We)&&(u.save(),Ae&&u.clip(Ae),ze&&u.clip(ze)),We?(pe&dn)==dn?(u.clip(We),Ve&&u.clip(Ve),wt(G,oe),an(_,J,S)):pe&du?(wt(G,oe),u.clip(We),an(_,J,S)):pe&zr&&(u.save(),u.clip(We),Ve&&u.clip(Ve),wt(G,oe),u.restore(),an(_,J,S)):(wt(G,oe),an(_,J,S)),(Ae||ze||We)&&u.restore()}function an(_,S,P){P>0&&(S instanceof Map?S.forEach((N,G)=>{u.strokeStyle=Mr=G,u.stroke(N)}):S!=null&&_&&u.stroke(S))}function wt(_,S){S instanceof Map?S.forEach((P,N)=>{u.fillStyle=ws=N,u.fill(P)}):S!=null&&_&&u.fill(S)}function ts(_,S,P,N){let G=A[_],J;if(N<=0)J=[0,0];else{let oe=G._space=G.space(n,_,S,P,N),pe=G._incrs=G.incrs(n,_,S,P,N,oe);J=av(S,P,pe,N,oe)}return G._found=J}function on(_,S,P,N,G,J,oe,pe,Ae,ze){let Ve=oe%2/2;v==1&&u.translate(Ve,Ve),Ie(pe,oe,Ae,ze,pe),u.beginPath();let We,ft,It,Rt,Mt=G+(N==0||N==3?-J:J);P==0?(ft=G,Rt=Mt):(We=G,It=Mt);for(let rt=0;rt<_.length;rt++)S[rt]!=null&&(P==0?We=It=_[rt]:ft=Rt=_[rt],u.moveTo(We,ft),u.lineTo(It,Rt));u.stroke(),v==1&&u.translate(-Ve,-Ve)}function wr(_){let S=!0;return A.forEach((P,N)=>{if(!P.show)return;let G=b[P.scale];if(G.min==null){P._show&&(S=!1,P._show=!1,_t(!1));return}else P._show||(S=!1,P._show=!0,_t(!1));let J=P.side,oe=J%2,{min:pe,max:Ae}=G,[ze,Ve]=ts(N,pe,Ae,oe==0?F:be);if(Ve==0)return;let We=G.distr==2,ft=P._splits=P.splits(n,N,pe,Ae,ze,Ve,We),It=G.distr==2?ft.map(Qe=>$n[Qe]):ft,Rt=G.distr==2?$n[ft[1]]-$n[ft[0]]:ze,Mt=P._values=P.values(n,P.filter(n,It,N,Ve,Rt),N,Ve,Rt);P._rotate=J==2?P.rotate(n,Mt,N,Ve):0;let rt=P._size;P._size=pi(P.size(n,Mt,N,_)),rt!=null&&P._size!=rt&&(S=!1)}),S}function Bi(_){let S=!0;return Ea.forEach((P,N)=>{let G=P(n,N,Ui,_);G!=_i[N]&&(S=!1),_i[N]=G}),S}function ns(){for(let _=0;_<A.length;_++){let S=A[_];if(!S.show||!S._show)continue;let P=S.side,N=P%2,G,J,oe=S.stroke(n,_),pe=P==0||P==3?-1:1,[Ae,ze]=S._found;if(S.label!=null){let On=S.labelGap*pe,Kn=fn((S._lpos+On)*Lt);Ue(S.labelFont[0],oe,"center",P==2?"top":zf),u.save(),N==1?(G=J=0,u.translate(Kn,fn(M+ue/2)),u.rotate((P==3?-gl:gl)/2)):(G=fn(R+X/2),J=Kn);let er=Rp(S.label)?S.label(n,_,Ae,ze):S.label;u.fillText(er,G,J),u.restore()}if(ze==0)continue;let Ve=b[S.scale],We=N==0?X:ue,ft=N==0?R:M,It=S._splits,Rt=Ve.distr==2?It.map(On=>$n[On]):It,Mt=Ve.distr==2?$n[It[1]]-$n[It[0]]:Ae,rt=S.ticks,Qe=S.border,qt=rt.show?rt.size:0,tn=fn(qt*Lt),yn=fn((S.alignTo==2?S._size-qt-S.gap:S.gap)*Lt),zt=S._rotate*-gl/180,nn=m(S._pos*Lt),Zn=(tn+yn)*pe,Un=nn+Zn;J=N==0?Un:0,G=N==1?Un:0;let hi=S.font[0],vi=S.align==1?Nr:S.align==2?Qh:zt>0?Nr:zt<0?Qh:N==0?"center":P==3?Qh:Nr,Vi=zt||N==1?"middle":P==2?"top":zf;Ue(hi,oe,vi,Vi);let Jn=S.font[1]*S.lineGap,ui=It.map(On=>m(o(On,Ve,We,ft))),yi=S._values;for(let On=0;On<yi.length;On++){let Kn=yi[On];if(Kn!=null){N==0?G=ui[On]:J=ui[On],Kn=""+Kn;let er=Kn.indexOf(`
`)==-1?[Kn]:Kn.split(/\n/gm);for(let Bn=0;Bn<er.length;Bn++){let Tf=er[Bn];zt?(u.save(),u.translate(G,J+Bn*Jn),u.rotate(zt),u.fillText(Tf,0,0),u.restore()):u.fillText(Tf,G,J+Bn*Jn)}}}rt.show&&on(ui,rt.filter(n,Rt,_,ze,Mt),N,P,nn,tn,Gt(rt.width*Lt,3),rt.stroke(n,_),rt.dash,rt.cap);let Gi=S.grid;Gi.show&&on(ui,Gi.filter(n,Rt,_,ze,Mt),N,N==0?2:1,N==0?M:R,N==0?ue:X,Gt(Gi.width*Lt,3),Gi.stroke(n,_),Gi.dash,Gi.cap),Qe.show&&on([nn],[1],N==0?1:0,N==0?1:2,N==1?M:R,N==1?ue:X,Gt(Qe.width*Lt,3),Qe.stroke(n,_),Qe.dash,Qe.cap)}vn("drawAxes")}function _t(_){y.forEach((S,P)=>{P>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(N=>{N.min=null,N.max=null})))})}let en=!1,Fn=!1,kt=[];function ln(){Fn=!1;for(let _=0;_<kt.length;_++)vn(...kt[_]);kt.length=0}function Cn(){en||(jx(of),en=!0)}function $o(_,S=!1){en=!0,Fn=S,_(n),of(),S&&kt.length>0&&queueMicrotask(ln)}n.batch=$o;function of(){if(ae&&(yt(),ae=!1),Te&&(Re(),Te=!1),Me){if(Yt(f,Nr,Xe),Yt(f,"top",ct),Yt(f,Ba,F),Yt(f,ka,be),Yt(p,Nr,Xe),Yt(p,"top",ct),Yt(p,Ba,F),Yt(p,ka,be),Yt(d,Ba,ut),Yt(d,ka,xt),h.width=fn(ut*Lt),h.height=fn(xt*Lt),A.forEach(({_el:_,_show:S,_size:P,_pos:N,side:G})=>{if(_!=null)if(S){let J=G===3||G===0?P:0,oe=G%2==1;Yt(_,oe?"left":"top",N-J),Yt(_,oe?"width":"height",P),Yt(_,oe?"top":"left",oe?ct:Xe),Yt(_,oe?"height":"width",oe?be:F),ou(_,rr)}else ei(_,rr)}),Mr=ws=Sr=B=K=Y=$=Pe=T=null,Fe=1,La(!0),Xe!=we||ct!=Dt||F!=$e||be!=je){_t(!1);let _=F/$e,S=be/je;if(ge&&!te&&ce.left>=0){ce.left*=_,ce.top*=S,Tr&&Wi(Tr,fn(ce.left),0,F,be),Ar&&Wi(Ar,0,fn(ce.top),F,be);for(let P=0;P<gt.length;P++){let N=gt[P];N!=null&&(Ht[P]*=_,Nn[P]*=S,Wi(N,pi(Ht[P]),pi(Nn[P]),F,be))}}if(Xt.show&&!ie&&Xt.left>=0&&Xt.width>0){Xt.left*=_,Xt.width*=_,Xt.top*=S,Xt.height*=S;for(let P in Wh)Yt(Rr,P,Xt[P])}we=Xe,Dt=ct,$e=F,je=be}vn("setSize"),Me=!1}ut>0&&xt>0&&(u.clearRect(0,0,h.width,h.height),vn("drawClear"),w.forEach(_=>_()),vn("draw")),Xt.show&&ie&&(Zo(Xt),ie=!1),ge&&te&&(js(null,!0,!1),te=!1),de.show&&de.live&&me&&(Gh(),me=!1),l||(l=!0,n.status=1,vn("ready")),Ss=!1,en=!1}n.redraw=(_,S)=>{Te=S||!1,_!==!1?As(E,I.min,I.max):Cn()};function kh(_,S){let P=b[_];if(P.from==null){if(jt==0){let N=P.range(n,S.min,S.max,_);S.min=N[0],S.max=N[1]}if(S.min>S.max){let N=S.min;S.min=S.max,S.max=N}if(jt>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==E&&P.distr==2&&jt>0&&(S.min=Si(S.min,e[0]),S.max=Si(S.max,e[0]),S.min==S.max&&S.max++),V[_]=S,ae=!0,Cn()}}n.setScale=kh;let zh,Vh,Tr,Ar,lf,cf,Er,Cr,hf,uf,Wt,Zt,Ts=!1,wn=ce.drag,xn=wn.x,_n=wn.y;ge&&(ce.x&&(zh=fi(Sx,p)),ce.y&&(Vh=fi(wx,p)),I.ori==0?(Tr=zh,Ar=Vh):(Tr=Vh,Ar=zh),Wt=ce.left,Zt=ce.top);let Xt=n.select=hn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Rr=Xt.show?fi(Mx,Xt.over?p:f):null;function Zo(_,S){if(Xt.show){for(let P in _)Xt[P]=_[P],P in Wh&&Yt(Rr,P,_[P]);S!==!1&&vn("setSelect")}}n.setSelect=Zo;function N0(_){if(y[_].show)j&&ou(it[_],rr);else if(j&&ei(it[_],rr),ge){let P=Ne?gt[0]:gt[_];P!=null&&Wi(P,-10,-10,F,be)}}function As(_,S,P){kh(_,{min:S,max:P})}function ki(_,S,P,N){S.focus!=null&&k0(_),S.show!=null&&y.forEach((G,J)=>{J>0&&(_==J||_==null)&&(G.show=S.show,N0(J),s==2?(As(G.facets[0].scale,null,null),As(G.facets[1].scale,null,null)):As(G.scale,null,null),Cn())}),P!==!1&&vn("setSeries",_,S),N&&Da("setSeries",n,_,S)}n.setSeries=ki;function F0(_,S){hn(C[_],S)}function U0(_,S){_.fill=Tt(_.fill||null),_.dir=Pt(_.dir,-1),S=S??C.length,C.splice(S,0,_)}function O0(_){_==null?C.length=0:C.splice(_,1)}n.addBand=U0,n.setBand=F0,n.delBand=O0;function B0(_,S){y[_].alpha=S,ge&&gt[_]!=null&&(gt[_].style.opacity=S),j&&it[_]&&(it[_].style.opacity=S)}let is,Es,Qs,Pr={focus:!0};function k0(_){if(_!=Qs){let S=_==null,P=qe.alpha!=1;y.forEach((N,G)=>{if(s==1||G>0){let J=S||G==0||G==_;N._focus=S?null:J,P&&B0(G,J?1:qe.alpha)}}),Qs=_,P&&Cn()}}j&&ot&&ke(Wf,Le,_=>{ce._lock||(at(_),Qs!=null&&ki(null,Pr,!0,cn.setSeries))});function zi(_,S,P){let N=b[S];P&&(_=_/Lt-(N.ori==1?ct:Xe));let G=F;N.ori==1&&(G=be,_=G-_),N.dir==-1&&(_=G-_);let J=N._min,oe=N._max,pe=_/G,Ae=J+(oe-J)*pe,ze=N.distr;return ze==3?Or(10,Ae):ze==4?Vx(Ae,N.asinh):ze==100?N.bwd(Ae):Ae}function z0(_,S){let P=zi(_,E,S);return Si(P,e[0],sn,rn)}n.valToIdx=_=>Si(_,e[0]),n.posToIdx=z0,n.posToVal=zi,n.valToPos=(_,S,P)=>b[S].ori==0?r(_,b[S],P?X:F,P?R:0):a(_,b[S],P?ue:be,P?M:0),n.setCursor=(_,S,P)=>{Wt=_.left,Zt=_.top,js(null,S,P)};function df(_,S){Yt(Rr,Nr,Xt.left=_),Yt(Rr,Ba,Xt.width=S)}function ff(_,S){Yt(Rr,"top",Xt.top=_),Yt(Rr,ka,Xt.height=S)}let Pa=I.ori==0?df:ff,Ia=I.ori==1?df:ff;function V0(){if(j&&de.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&tt)continue;let S=de.values[_],P=0;for(let N in S)Je[_][P++].firstChild.nodeValue=S[N]}}function Gh(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{ee[N]=P}):Xx(_.idx)||ee.fill(_.idx),de.idx=ee[0]),j&&de.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!tt)&&G0(P,ee[P]);V0()}me=!1,S!==!1&&vn("setLegend")}n.setLegend=Gh;function G0(_,S){let P=y[_],N=_==0&&k==2?$n:e[_],G;tt?G=P.values(n,_,S)??re:(G=P.value(n,S==null?null:N[S],_,S),G=G==null?re:{_:G}),de.values[_]=G}function js(_,S,P){hf=Wt,uf=Zt,[Wt,Zt]=ce.move(n,Wt,Zt),ce.left=Wt,ce.top=Zt,ge&&(Tr&&Wi(Tr,fn(Wt),0,F,be),Ar&&Wi(Ar,0,fn(Zt),F,be));let N,G=sn>rn;is=Vt,Es=null;let J=I.ori==0?F:be,oe=I.ori==1?F:be;if(Wt<0||jt==0||G){N=ce.idx=null;for(let pe=0;pe<y.length;pe++){let Ae=gt[pe];Ae!=null&&Wi(Ae,-10,-10,F,be)}ot&&ki(null,Pr,!0,_==null&&cn.setSeries),de.live&&(ee.fill(N),me=!0)}else{let pe,Ae,ze;s==1&&(pe=I.ori==0?Wt:Zt,Ae=zi(pe,E),N=ce.idx=Si(Ae,e[0],sn,rn),ze=H(e[0][N],I,J,0));let Ve=-10,We=-10,ft=0,It=0,Rt=!0,Mt="",rt="";for(let Qe=s==2?1:0;Qe<y.length;Qe++){let qt=y[Qe],tn=ee[Qe],yn=tn==null?null:s==1?e[Qe][tn]:e[Qe][1][tn],zt=ce.dataIdx(n,Qe,N,Ae),nn=zt==null?null:s==1?e[Qe][zt]:e[Qe][1][zt];if(me=me||nn!=yn||zt!=tn,ee[Qe]=zt,Qe>0&&qt.show){let Zn=zt==null?-10:zt==N?ze:H(s==1?e[0][zt]:e[Qe][0][zt],I,J,0),Un=nn==null?-10:D(nn,s==1?b[qt.scale]:b[qt.facets[1].scale],oe,0);if(ot&&nn!=null){let hi=I.ori==1?Wt:Zt,vi=pn(qe.dist(n,Qe,zt,Un,hi));if(vi<is){let Vi=qe.bias;if(Vi!=0){let Jn=zi(hi,qt.scale),ui=nn>=0?1:-1,yi=Jn>=0?1:-1;yi==ui&&(yi==1?Vi==1?nn>=Jn:nn<=Jn:Vi==1?nn<=Jn:nn>=Jn)&&(is=vi,Es=Qe)}else is=vi,Es=Qe}}if(me||Ne){let hi,vi;I.ori==0?(hi=Zn,vi=Un):(hi=Un,vi=Zn);let Vi,Jn,ui,yi,Gi,On,Kn=!0,er=he.bbox;if(er!=null){Kn=!1;let Bn=er(n,Qe);ui=Bn.left,yi=Bn.top,Vi=Bn.width,Jn=Bn.height}else ui=hi,yi=vi,Vi=Jn=he.size(n,Qe);if(On=he.fill(n,Qe),Gi=he.stroke(n,Qe),Ne)Qe==Es&&is<=qe.prox&&(Ve=ui,We=yi,ft=Vi,It=Jn,Rt=Kn,Mt=On,rt=Gi);else{let Bn=gt[Qe];Bn!=null&&(Ht[Qe]=ui,Nn[Qe]=yi,Kf(Bn,Vi,Jn,Kn),Zf(Bn,On,Gi),Wi(Bn,pi(ui),pi(yi),F,be))}}}}if(Ne){let Qe=qe.prox,qt=Qs==null?is<=Qe:is>Qe||Es!=Qs;if(me||qt){let tn=gt[0];tn!=null&&(Ht[0]=Ve,Nn[0]=We,Kf(tn,ft,It,Rt),Zf(tn,Mt,rt),Wi(tn,pi(Ve),pi(We),F,be))}}}if(Xt.show&&Ts)if(_!=null){let[pe,Ae]=cn.scales,[ze,Ve]=cn.match,[We,ft]=_.cursor.sync.scales,It=_.cursor.drag;if(xn=It._x,_n=It._y,xn||_n){let{left:Rt,top:Mt,width:rt,height:Qe}=_.select,qt=_.scales[We].ori,tn=_.posToVal,yn,zt,nn,Zn,Un,hi=pe!=null&&ze(pe,We),vi=Ae!=null&&Ve(Ae,ft);hi&&xn?(qt==0?(yn=Rt,zt=rt):(yn=Mt,zt=Qe),nn=b[pe],Zn=H(tn(yn,We),nn,J,0),Un=H(tn(yn+zt,We),nn,J,0),Pa(wi(Zn,Un),pn(Un-Zn))):Pa(0,J),vi&&_n?(qt==1?(yn=Rt,zt=rt):(yn=Mt,zt=Qe),nn=b[Ae],Zn=D(tn(yn,ft),nn,oe,0),Un=D(tn(yn+zt,ft),nn,oe,0),Ia(wi(Zn,Un),pn(Un-Zn))):Ia(0,oe)}else Xh()}else{let pe=pn(hf-lf),Ae=pn(uf-cf);if(I.ori==1){let ft=pe;pe=Ae,Ae=ft}xn=wn.x&&pe>=wn.dist,_n=wn.y&&Ae>=wn.dist;let ze=wn.uni;ze!=null?xn&&_n&&(xn=pe>=ze,_n=Ae>=ze,!xn&&!_n&&(Ae>pe?_n=!0:xn=!0)):wn.x&&wn.y&&(xn||_n)&&(xn=_n=!0);let Ve,We;xn&&(I.ori==0?(Ve=Er,We=Wt):(Ve=Cr,We=Zt),Pa(wi(Ve,We),pn(We-Ve)),_n||Ia(0,oe)),_n&&(I.ori==1?(Ve=Er,We=Wt):(Ve=Cr,We=Zt),Ia(wi(Ve,We),pn(We-Ve)),xn||Pa(0,J)),!xn&&!_n&&(Pa(0,0),Ia(0,0))}if(wn._x=xn,wn._y=_n,_==null){if(P){if(wf!=null){let[pe,Ae]=cn.scales;cn.values[0]=pe!=null?zi(I.ori==0?Wt:Zt,pe):null,cn.values[1]=Ae!=null?zi(I.ori==1?Wt:Zt,Ae):null}Da(jh,n,Wt,Zt,F,be,N)}if(ot){let pe=P&&cn.setSeries,Ae=qe.prox;Qs==null?is<=Ae&&ki(Es,Pr,!0,pe):is>Ae?ki(null,Pr,!0,pe):Es!=Qs&&ki(Es,Pr,!0,pe)}}me&&(de.idx=N,Gh()),S!==!1&&vn("setCursor")}let Cs=null;Object.defineProperty(n,"rect",{get(){return Cs==null&&La(!1),Cs}});function La(_=!1){_?Cs=null:(Cs=p.getBoundingClientRect(),vn("syncRect",Cs))}function pf(_,S,P,N,G,J,oe){ce._lock||Ts&&_!=null&&_.movementX==0&&_.movementY==0||(Hh(_,S,P,N,G,J,oe,!1,_!=null),_!=null?js(null,!0,!0):js(S,!0,!1))}function Hh(_,S,P,N,G,J,oe,pe,Ae){if(Cs==null&&La(!1),at(_),_!=null)P=_.clientX-Cs.left,N=_.clientY-Cs.top;else{if(P<0||N<0){Wt=-10,Zt=-10;return}let[ze,Ve]=cn.scales,We=S.cursor.sync,[ft,It]=We.values,[Rt,Mt]=We.scales,[rt,Qe]=cn.match,qt=S.axes[0].side%2==1,tn=I.ori==0?F:be,yn=I.ori==1?F:be,zt=qt?J:G,nn=qt?G:J,Zn=qt?N:P,Un=qt?P:N;if(Rt!=null?P=rt(ze,Rt)?o(ft,b[ze],tn,0):-10:P=tn*(Zn/zt),Mt!=null?N=Qe(Ve,Mt)?o(It,b[Ve],yn,0):-10:N=yn*(Un/nn),I.ori==1){let hi=P;P=N,N=hi}}Ae&&(S==null||S.cursor.event.type==jh)&&((P<=1||P>=F-1)&&(P=ir(P,F)),(N<=1||N>=be-1)&&(N=ir(N,be))),pe?(lf=P,cf=N,[Er,Cr]=ce.move(n,P,N)):(Wt=P,Zt=N)}let Wh={width:0,height:0,left:0,top:0};function Xh(){Zo(Wh,!1)}let mf,gf,xf,_f;function vf(_,S,P,N,G,J,oe){Ts=!0,xn=_n=wn._x=wn._y=!1,Hh(_,S,P,N,G,J,oe,!0,!1),_!=null&&(ke(eu,ru,yf,!1),Da(Gf,n,Er,Cr,F,be,null));let{left:pe,top:Ae,width:ze,height:Ve}=Xt;mf=pe,gf=Ae,xf=ze,_f=Ve}function yf(_,S,P,N,G,J,oe){Ts=wn._x=wn._y=!1,Hh(_,S,P,N,G,J,oe,!1,!0);let{left:pe,top:Ae,width:ze,height:Ve}=Xt,We=ze>0||Ve>0,ft=mf!=pe||gf!=Ae||xf!=ze||_f!=Ve;if(We&&ft&&Zo(Xt),wn.setScale&&We&&ft){let It=pe,Rt=ze,Mt=Ae,rt=Ve;if(I.ori==1&&(It=Ae,Rt=Ve,Mt=pe,rt=ze),xn&&As(E,zi(It,E),zi(It+Rt,E)),_n)for(let Qe in b){let qt=b[Qe];Qe!=E&&qt.from==null&&qt.min!=Vt&&As(Qe,zi(Mt+rt,Qe),zi(Mt,Qe))}Xh()}else ce.lock&&(ce._lock=!ce._lock,js(S,!0,_!=null));_!=null&&(pt(eu,ru),Da(eu,n,Wt,Zt,F,be,null))}function H0(_,S,P,N,G,J,oe){if(ce._lock)return;at(_);let pe=Ts;if(Ts){let Ae=!0,ze=!0,Ve=10,We,ft;I.ori==0?(We=xn,ft=_n):(We=_n,ft=xn),We&&ft&&(Ae=Wt<=Ve||Wt>=F-Ve,ze=Zt<=Ve||Zt>=be-Ve),We&&Ae&&(Wt=Wt<Er?0:F),ft&&ze&&(Zt=Zt<Cr?0:be),js(null,!0,!0),Ts=!1}Wt=-10,Zt=-10,ee.fill(null),js(null,!0,!0),pe&&(Ts=pe)}function bf(_,S,P,N,G,J,oe){ce._lock||(at(_),Ra(),Xh(),_!=null&&Da(Xf,n,Wt,Zt,F,be,null))}function Mf(){A.forEach(ov),U(n.width,n.height,!0)}ar(xl,Ur,Mf);let Ir={};Ir.mousedown=vf,Ir.mousemove=pf,Ir.mouseup=yf,Ir.dblclick=bf,Ir.setSeries=(_,S,P,N)=>{let G=cn.match[2];P=G(n,S,P),P!=-1&&ki(P,N,!0,!1)},ge&&(ke(Gf,p,vf),ke(jh,p,pf),ke(Hf,p,_=>{at(_),La(!1)}),ke(Wf,p,H0),ke(Xf,p,bf),fu.add(n),n.syncRect=La);let Jo=n.hooks=i.hooks||{};function vn(_,S,P){Fn?kt.push([_,S,P]):_ in Jo&&Jo[_].forEach(N=>{N.call(null,n,S,P)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)Jo[S]=(Jo[S]||[]).concat(_.hooks[S])});let Sf=(_,S,P)=>P,cn=hn({key:null,setSeries:!1,filters:{pub:np,sub:np},scales:[E,y[1]?y[1].scale:null],match:[ip,ip,Sf],values:[null,null]},ce.sync);cn.match.length==2&&cn.match.push(Sf),ce.sync=cn;let wf=cn.key,qh=jp(wf);function Da(_,S,P,N,G,J,oe){cn.filters.pub(_,S,P,N,G,J,oe)&&qh.pub(_,S,P,N,G,J,oe)}qh.sub(n);function W0(_,S,P,N,G,J,oe){cn.filters.sub(_,S,P,N,G,J,oe)&&Ir[_](null,S,P,N,G,J,oe)}n.pub=W0;function X0(){qh.unsub(n),fu.delete(n),et.clear(),lu(xl,Ur,Mf),c.remove(),Le?.remove(),vn("destroy")}n.destroy=X0;function Yh(){vn("init",i,e),Ca(e||i.data,!1),V[E]?kh(E,V[E]):Ra(),ie=Xt.show&&(Xt.width>0||Xt.height>0),te=me=!0,U(i.width,i.height)}return y.forEach(br),A.forEach(ji),t?t instanceof HTMLElement?(t.appendChild(c),Yh()):t(n,Yh):Yh(),n}An.assign=hn;An.fmtNum=yu;An.rangeNum=_l;An.rangeLog=bl;An.rangeAsinh=_u;An.orient=lr;An.pxRatio=Lt;An.join=Qx;An.fmtDate=Mu,An.tzDate=c_;An.sync=jp;{An.addGap=X_,An.clipGaps=wl;let i=An.paths={points:rm};i.linear=om,i.stepped=$_,i.bars=Z_,i.spline=K_}var lv=6e5,[cv,hv]=[60,600];function um(i,e,t){let n=lv/Math.max(1,i.balls.length*e.length),s=Math.round(Math.min(hv,Math.max(cv,n/2))),r=[...new Set(e.flatMap(l=>l.events.map(c=>c.at)))].filter(l=>l>0&&l<t).sort((l,c)=>l-c),a=Math.max(1,Math.ceil(2*r.length/Math.max(1,n-s))),o=[];for(let l=0;l<=s;l+=1)o.push([t*l/s,0]);for(let l=0;l<r.length;l+=a)o.push([r[l],1],[r[l],0]);return o.sort((l,c)=>l[0]-c[0]||c[1]-l[1]),{at:Float64Array.from(o,l=>l[0]),near:Uint8Array.from(o,l=>l[1])}}function dm(i,e,t){let n=t.at.length,s=new Float64Array(n),r=new Float64Array(n),a=new Float64Array(n),o=bi();i.balls.forEach((c,h)=>{let u=c.inertia/(i.R*i.R);for(let d=0;d<n;d+=1){let f=t.at[d],p=t.near[d]===1;if((p?f>e.leaves[h]:f>=e.leaves[h])||!e.paths[h]?.at(f,o,p))continue;let v=Ru(o.velocity);s[d]+=v,r[d]+=1,a[d]+=(c.mass*v+u*Ru(o.spin))/2}});let l=s.map((c,h)=>r[h]>0?Math.sqrt(c/r[h]):0);return{rms:Pu(l,t,e.facts.end),energy:Pu(a,t,e.facts.end)}}function fm(i,e,t){let n=bi(),s=Float64Array.from(t.at,(r,a)=>{let o=t.near[a]===1;return!(o?r>i.leaves[e]:r>=i.leaves[e])&&i.paths[e]?.at(r,n,o)?Math.sqrt(Ru(n.velocity)):NaN});return Pu(s,t,i.facts.end)}function Ru(i){return i[0]*i[0]+i[1]*i[1]+i[2]*i[2]}function Pu(i,e,t){let n=Math.fround(t)*1.000001,s=NaN;return i.map((r,a)=>e.at[a]<=n?(s=r,r):s===0?0:NaN)}function Wr(i,e,t){let n=0,s=i.length;for(;n<s;){let o=n+s>>1;i[o]<=t?n=o+1:s=o}if(n===0)return NaN;let r=e[n-1]??NaN;if(n===i.length||t===i[n-1])return r;let a=e[n]??NaN;return r+(t-i[n-1])/(i[n]-i[n-1])*(a-r)}var pm=210,mm=11,Xr=class{constructor(e,...t){this.facts=e;this.data=fe("details",{},fe("summary",{},"Data"),fe("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":`${e.title}, data`},this.table)),this.data.addEventListener("toggle",()=>this.fill()),this.element=fe("figure",{class:"rp-chart"},fe("figcaption",{},fe("b",{},e.title),...t),this.host,this.values,this.data)}facts;element;host=fe("div",{class:"rp-plot"});values=fe("p",{class:"rp-values"});table=fe("table",{});data;nowLine=fe("div",{class:"rp-now-line"});future=fe("div",{class:"rp-future"});plot=null;content={at:new Float64Array(0),lines:[]};time=0;told=-1/0;width=0;show(e){this.content=e,this.build()}resize(e){Math.abs(e-this.width)>=1&&(this.width=e,this.plot?(this.plot.setSize({width:e,height:pm}),this.go(this.time,!1)):this.build())}go(e,t){this.time=e;let{plot:n}=this;if(!n)return;let s=n.valToPos(e,"x");this.nowLine.style.transform=`translateX(${s.toFixed(2)}px)`,this.facts.growing&&(this.future.style.transform=`translateX(${s.toFixed(2)}px)`);let r=performance.now();(!t||r-this.told>200)&&(this.told=r,this.tell())}build(){this.plot?.destroy(),this.plot=null;let{content:e,facts:t,host:n,width:s}=this;if(s<40||e.at.length===0)return;let r=getComputedStyle(this.element),[a,o]=[r.getPropertyValue("--rp-soft").trim(),r.getPropertyValue("--rp-rule").trim()],l=`12px ${r.fontFamily}`,c={stroke:a,grid:{stroke:o,width:1},ticks:{stroke:o,width:1,size:5},font:l,labelFont:l,labelSize:18},h=e.lines.flatMap(g=>Array.from(g.values).filter(y=>y>0)),u=h.reduce((g,y)=>Math.min(g,y),1/0),d=h.reduce((g,y)=>Math.max(g,y),0),f=(g,y)=>10**(y?Math.ceil(Math.log10(g)+.05):Math.floor(Math.log10(g))),p=t.log?[f(Math.max(u,1e-17),!1),f(Math.max(d,1e-16),!0)]:[0,d*1.06||1],v={width:s,height:pm,padding:[8,14,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5}},select:{show:!1,left:0,top:0,width:0,height:0},scales:{x:{time:!1,range:[0,t.end||1]},y:t.log?{distr:3,log:10,range:p}:{range:p}},axes:[{...c,label:`time, ${t.timeUnit}`,size:34},{...c,label:t.axis,size:50,...t.log?{splits:()=>uv(p),filter:(g,y)=>y}:{},values:(g,y)=>y.map(A=>t.log?`1e${Math.round(Math.log10(A))}`.replace(/^1e0$/,"1"):nr(A))}],series:[{},...e.lines.map(g=>({label:g.label,stroke:Zh(g.run),width:1.8,dash:Qn(g.run).dash,points:{show:!1}}))],hooks:{draw:[g=>this.marks(g),g=>this.labels(g)]}},m=e.lines.map(g=>Array.from(g.values,y=>Number.isFinite(y)&&(!t.log||y>0)?y:null));this.plot=new An(v,[Array.from(e.at),...m],n),this.plot.over.append(this.nowLine),t.growing&&this.plot.over.append(this.future),this.hold(this.plot),this.go(this.time,!1),this.fill()}destroy(){this.plot?.destroy(),this.plot=null}hold(e){let{over:t}=e,n=s=>{let r=t.getBoundingClientRect();this.facts.seek(e.posToVal(s.clientX-r.left,"x"))};t.addEventListener("pointerdown",s=>{t.setPointerCapture(s.pointerId),n(s)}),t.addEventListener("pointermove",s=>{(s.buttons&1)!==0&&n(s)})}marks(e){let{ctx:t,bbox:n}=e,s=getComputedStyle(this.element),r=(a,o,l,c)=>{let h=e.valToPos(a,"x",!0);t.save(),t.strokeStyle=o,t.fillStyle=o,t.lineWidth=devicePixelRatio,t.setLineDash(l.map(f=>f*devicePixelRatio)),t.beginPath(),t.moveTo(h,n.top),t.lineTo(h,n.top+n.height),t.stroke(),t.font=`${10.5*devicePixelRatio}px ${s.fontFamily}`;let u=t.measureText(c).width,d=h+u+8*devicePixelRatio<n.left+n.width;t.textAlign=d?"left":"right",t.fillText(c,h+(d?4:-4)*devicePixelRatio,n.top+10*devicePixelRatio),t.restore()};this.facts.partings.length>0&&r(this.facts.partings[0],s.getPropertyValue("--rp-bad").trim(),[],"first divergence");for(let a of this.facts.partings.slice(1))r(a,s.getPropertyValue("--rp-bad").trim(),[2,3],"");this.facts.horizon!==null&&r(this.facts.horizon,s.getPropertyValue("--rp-soft").trim(),[6,3],"horizon")}labels(e){let{ctx:t,bbox:n}=e,{lines:s,at:r}=this.content;if(s.length<2)return;let a=devicePixelRatio,o=12*a;t.save(),t.font=`600 ${11*a}px ${getComputedStyle(this.element).fontFamily}`,t.textAlign="center";let l=[];s.forEach((c,h)=>{let u=t.measureText(c.label).width+6*a,d={x:0,y:0,room:0};for(let f=n.left+u/2+2*a;f<n.left+n.width-u/2;f+=n.width/60){let p=[-.5,-.25,0,.25,.5].map(x=>{let w=e.posToVal((f+x*u-n.left)/a,"x");return s.map(O=>e.valToPos(Wr(r,O.values,w),"y",!0))}),v=p.map(x=>x[h]);if(!v.every(Number.isFinite))continue;let m=Math.min(...v)-5*a,g=m-o/3,y=p.flatMap(x=>x.filter((w,O)=>O!==h&&Number.isFinite(w))).map(x=>Math.abs(x-g)-o/2),A=p.flatMap(x=>x.filter((w,O)=>O!==h&&Number.isFinite(w)).map(w=>Math.abs(w-x[h])-9*a)),b=l.map(x=>Math.max(Math.abs(x.x-f)-(x.w+u)/2,Math.abs(x.y-m)-o)),C=Math.max(...v)-Math.min(...v),E=Math.min(40*a,m-o-n.top-12*a,...y,...A,...b)-.6*C;E>d.room&&(d={x:f,y:m,room:E})}d.room>0&&(t.fillStyle=Zh(c.run),t.fillText(c.label,d.x,d.y),l.push({x:d.x,y:d.y,w:u}))}),t.restore()}tell(){let{content:e,facts:t}=this,n=e.lines.map(s=>`${s.label} ${nr(Wr(e.at,s.values,this.time))}`);di(this.values,n.length>0?`${Tn(this.time,t.end)} ${t.timeUnit}: ${n.join(" · ")}`:""),this.data.open&&this.fill()}fill(){if(!this.data.open)return;let{content:e,facts:t}=this,n=(o,l)=>fe("tr",{},fe("th",{scope:"row",class:"r"},l),...e.lines.map(c=>fe("td",{class:"r"},nr(Wr(e.at,c.values,o))))),s=Array.from({length:mm},(o,l)=>t.end*l/(mm-1)),r=t.growing?s.filter(o=>o<=this.time):s,a=fe("tr",{},fe("th",{scope:"col",class:"r"},`time, ${t.timeUnit}`),...e.lines.map(o=>fe("th",{scope:"col",class:"r"},`${o.label}, ${t.axis}`)));this.table.replaceChildren(fe("thead",{},a),fe("tbody",{},n(this.time,`now: ${Tn(this.time,t.end)}`),...r.map(o=>n(o,Tn(o,t.end)))))}};function uv([i,e]){let[t,n]=[Math.round(Math.log10(i)),Math.round(Math.log10(e))],s=Math.max(1,Math.ceil((n-t)/6)),r=[];for(let a=Math.ceil(t/s)*s;a<=n;a+=s)r.push(10**a);return r}var Cl=class{constructor(e,t,n){this.stage=e;let{data:s,runs:r,end:a}=e,o=s.scene.time_unit,l=(c,h,u=!1)=>({title:c,axis:h,log:u,growing:n,timeUnit:o,end:a,partings:s.partings.map(d=>d.time),horizon:s.horizon,seek:d=>t.seek(d)});this.ball=fe("select",{"aria-label":"Speed of"},fe("option",{value:-1},"all balls, rms"),...s.balls.map((c,h)=>fe("option",{value:h},`ball ${c.id}`))),this.ball.addEventListener("change",()=>t.follow(Number(this.ball.value))),this.speed=new Xr(l("Speed",`speed, ${s.scene.length_unit}/${o}`),fe("label",{}," of ",this.ball)),this.energy=new Xr(l("Kinetic energy","energy, E0")),this.divergence=s.divergence.some(c=>c.points.some(([,h])=>h>0))?new Xr(l("Distance between engines, worst ball","distance, R",!0)):null,this.when=um(s,r,a),this.initial=dv(e);for(let c of this.charts())this.element.append(c.element);this.sizes=new ResizeObserver(c=>{for(let h of c)this.charts().find(u=>u.element===h.target)?.resize(Math.floor(h.contentRect.width))}),this.charts().forEach(c=>this.sizes.observe(c.element)),this.dark.addEventListener("change",this.recolour)}stage;element=fe("div",{class:"rp-plots"});speed;energy;divergence;ball;when;made=new Map;sizes;dark=matchMedia("(prefers-color-scheme: dark)");choice=null;initial;choose(e){let t=this.choice,n=t!==null&&t.ball===e.ball&&t.solid===e.solid&&t.shown.join()===e.shown.join();if(this.choice={...e,shown:[...e.shown]},n)return;this.ball.value=String(e.ball);let{stage:s,when:r}=this,{data:a}=s,o=s.runs.filter(c=>e.shown[c.index]||c.index===e.solid),l=c=>({at:r.at,lines:o.map(h=>({label:h.facts.label,run:h.index,values:c(h.index)}))});this.speed.show(l(c=>(e.ball<0?this.curves(c).rms:fm(s.runs[c],e.ball,r)).map(h=>h*a.R))),this.energy.show(l(c=>this.curves(c).energy.map(h=>this.initial>0?h/this.initial:h))),this.divergence?.show(this.pairs(e))}go(e,t){for(let n of this.charts())n.go(e,t)}destroy(){this.dark.removeEventListener("change",this.recolour),this.sizes.disconnect();for(let e of this.charts())e.destroy()}recolour=()=>this.charts().forEach(e=>e.build());charts(){return[this.speed,this.energy,...this.divergence?[this.divergence]:[]]}curves(e){let t=this.made.get(e);return t||(t=dm(this.stage.data,this.stage.runs[e],this.when),this.made.set(e,t)),t}pairs(e){let{data:t}=this.stage,n=o=>e.shown[o]||o===e.solid,s=t.divergence.filter(o=>n(o.run)&&n(o.against)),r=Float64Array.from(new Set(s.flatMap(o=>o.points.map(([l])=>l)))).sort(),a=s.map(o=>{let[l,c]=[o.points.map(([d])=>d),o.points.map(([,d])=>d)],h=t.runs[o.run].label,u=t.runs[o.against];return{label:u.reference?h:`${h} to ${u.label}`,run:o.run,values:Float64Array.from(r,d=>d<=l[l.length-1]?Wr(l,c,d):NaN)}});return{at:r,lines:a}}};function dv(i){let{data:e,runs:t}=i,n=bi();for(let s of t)if(s.paths.every(r=>r.count>0))return e.balls.reduce((r,a,o)=>{s.paths[o].at(0,n,!0);let l=n.velocity.reduce((h,u)=>h+u*u,0),c=n.spin.reduce((h,u)=>h+u*u,0);return r+(a.mass*l+a.inertia/e.R**2*c)/2},0);return 0}var fv=250,Rl=class{constructor(e){this.stage=e;let{balls:t,rotates:n,scene:s}=e.data,[r,a]=[s.length_unit,s.time_unit],o=[`x, ${r}`,`y, ${r}`,`speed, ${r}/${a}`,...n?[`spin, rad/${a}`]:[],"state"],l=fe("tr",{},fe("th",{scope:"col"},"ball"),...o.map(u=>fe("th",{scope:"col",class:"r"},u))),c=t.map(u=>{let d=o.map(()=>fe("td",{class:"r"}));return this.cells.push(d),fe("tr",{"data-ball":u.id},fe("th",{scope:"row"},u.id),...d)}),h=fe("table",{},this.caption,fe("thead",{},l),fe("tbody",{},...c));this.element=fe("details",{class:"rp-readout"},fe("summary",{},"Where the balls are now"),fe("div",{class:"rp-scroll",tabindex:0,role:"region","aria-label":"Where the balls are now"},h))}stage;element;caption=fe("caption",{});cells=[];last=-1/0;tell(e,t,n){let s=performance.now();if(n&&(!this.element.open||s-this.last<fv))return;this.last=s;let{data:r,end:a}=this.stage,o=e.scatters[t],l=Jh(r.R,4);di(this.caption,`${o.run.facts.label} at ${Tn(e.time,a)} ${r.scene.time_unit}`),this.cells.forEach((c,h)=>{let u=g=>r.origin[g]+r.R*o.positions[3*h+g],d=g=>Math.hypot(g[3*h],g[3*h+1],g[3*h+2]),f=d(o.velocities)*r.R,p=d(o.spins),v=o.present[h]?f>0?"moves":p>0?"spins":"rests":"fallen";[u(0).toFixed(l),u(1).toFixed(l),nr(f,5),...r.rotates?[nr(p,5)]:[],v].forEach((g,y)=>di(c[y],g))})}};var Ym=0,fd=1,$m=2;var Ro=1,Zm=2,_a=3,Zs=0,Xn=1,Ln=2,gr=0,va=1,pd=2,md=3,gd=4,Jm=5;var xr=100,Km=101,Qm=102,jm=103,eg=104,tg=200,ng=201,ig=202,sg=203,xd=204,_d=205,rg=206,ag=207,og=208,lg=209,cg=210,hg=211,ug=212,dg=213,fg=214,tc=0,nc=1,ic=2,oa=3,sc=4,rc=5,ac=6,oc=7,Oc=0,pg=1,mg=2,Ji=0,vd=1,yd=2,bd=3,Md=4,Sd=5,wd=6,Po=7;var Td=300,_r=301,ya=302,Bc=303,kc=304,fr=1e3,qi=1001,lc=1002,Mn=1003,gg=1004;var Io=1005;var Vn=1006,zc=1007;var vs=1008;var Yn=1009,Ad=1010,Ed=1011,ba=1012,Vc=1013,Di=1014,xi=1015,Ni=1016,Gc=1017,Hc=1018,vr=1020,Cd=35902,Rd=35899,Pd=1021,Id=1022,Fi=1023,ps=1026,ys=1027,Wc=1028,Xc=1029,Js=1030,qc=1031;var Yc=1033,Lo=33776,Do=33777,No=33778,Fo=33779,$c=35840,Zc=35841,Jc=35842,Kc=35843,Qc=36196,jc=37492,eh=37496,th=37488,nh=37489,Uo=37490,ih=37491,sh=37808,rh=37809,ah=37810,oh=37811,lh=37812,ch=37813,hh=37814,uh=37815,dh=37816,fh=37817,ph=37818,mh=37819,gh=37820,xh=37821,_h=36492,vh=36494,yh=36495,bh=36283,Mh=36284,Oo=36285,Sh=36286;var eo=2300,cc=2301,jl=2302,nd=2303,id=2400,sd=2401,rd=2402;var xg=3200;var wh=0,_g=1,bs="",En="srgb",to="srgb-linear",no="linear",Ft="srgb";var ec=7680;var vg=519,yg=512,bg=513,Mg=514,Ld=515,Sg=516,wg=517,Dd=518,Nd=519,Tg=35044,Fd=35048;var Ud="300 es",gi=2e3,la=2001;function pv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function mv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function io(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Ag(){let i=io("canvas");return i.style.display="block",i}var gm={},ca=null;function Od(...i){let e="THREE."+i.shift();ca?ca("log",e,...i):console.log(e,...i)}function Eg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function nt(...i){i=Eg(i);let e="THREE."+i.shift();if(ca)ca("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function lt(...i){i=Eg(i);let e="THREE."+i.shift();if(ca)ca("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ka(...i){let e=i.join(" ");e in gm||(gm[e]=!0,nt(...i))}function Cg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Rg={[tc]:tc,[ic]:ac,[sc]:sc,[oa]:rc,[nc]:nc,[ac]:ic,[oc]:oc,[rc]:oa},$i=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Rn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Iu=Math.PI/180,hc=180/Math.PI;function Ma(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Rn[i&255]+Rn[i>>8&255]+Rn[i>>16&255]+Rn[i>>24&255]+"-"+Rn[e&255]+Rn[e>>8&255]+"-"+Rn[e>>16&15|64]+Rn[e>>24&255]+"-"+Rn[t&63|128]+Rn[t>>8&255]+"-"+Rn[t>>16&255]+Rn[t>>24&255]+Rn[n&255]+Rn[n>>8&255]+Rn[n>>16&255]+Rn[n>>24&255]).toLowerCase()}function St(i,e,t){return Math.max(e,Math.min(t,i))}function gv(i,e){return(i%e+e)%e}function Lu(i,e,t){return(1-t)*i+t*e}function Pg(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Bd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function xv(i,e){if(e.constructor===Float32Array)return i;let t=Bd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function _v(i,e){if(e.constructor===Float32Array)return i;let t=Bd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Ee=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(St(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(St(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[a+0],f=r[a+1],p=r[a+2],v=r[a+3];if(u!==v||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*v;m<0&&(d=-d,f=-f,p=-p,v=-v,m=-m);let g=1-o;if(m<.9995){let y=Math.acos(m),A=Math.sin(y);g=Math.sin(g*y)/A,o=Math.sin(o*y)/A,l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+v*o}else{l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+v*o;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[a],d=r[a+1],f=r[a+2],p=r[a+3];return e[t]=o*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-o*f,e[t+2]=c*p+h*f+o*d-l*u,e[t+3]=h*p-o*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),u=o(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(a){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:nt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+o+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(n>o&&n>u){let f=2*Math.sqrt(1+n-o-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>u){let f=2*Math.sqrt(1+o-n-u);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(St(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(xm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(xm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),u=2*(r*n-a*t);return this.x=t+l*c+a*u-o*h,this.y=n+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(St(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Du.copy(this).projectOnVector(e),this.sub(Du)}reflect(e){return this.sub(Du.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(St(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Du=new W,xm=new Gn,dt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],v=s[0],m=s[3],g=s[6],y=s[1],A=s[4],b=s[7],C=s[2],E=s[5],x=s[8];return r[0]=a*v+o*y+l*C,r[3]=a*m+o*A+l*E,r[6]=a*g+o*b+l*x,r[1]=c*v+h*y+u*C,r[4]=c*m+h*A+u*E,r[7]=c*g+h*b+u*x,r[2]=d*v+f*y+p*C,r[5]=d*m+f*A+p*E,r[8]=d*g+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=h*a-o*c,d=o*l-h*r,f=c*r-a*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=u*v,e[1]=(s*c-h*n)*v,e[2]=(o*n-s*a)*v,e[3]=d*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-o*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(a*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Ka("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nu.makeScale(e,t)),this}rotate(e){return Ka("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nu.makeRotation(-e)),this}translate(e,t){return Ka("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nu=new dt,_m=new dt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vm=new dt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function vv(){let i={enabled:!0,workingColorSpace:to,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Ft&&(s.r=fs(s.r),s.g=fs(s.g),s.b=fs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Ft&&(s.r=aa(s.r),s.g=aa(s.g),s.b=aa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===bs?no:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[to]:{primaries:e,whitePoint:n,transfer:no,toXYZ:_m,fromXYZ:vm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:En},outputColorSpaceConfig:{drawingBufferColorSpace:En}},[En]:{primaries:e,whitePoint:n,transfer:Ft,toXYZ:_m,fromXYZ:vm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:En}}}),i}var At=vv();function fs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function aa(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var qr,uc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{qr===void 0&&(qr=io("canvas")),qr.width=e.width,qr.height=e.height;let s=qr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=qr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=io("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=fs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(fs(t[n]/255)*255):t[n]=fs(t[n]);return{data:t,width:e.width,height:e.height}}else return nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},yv=0,ha=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:yv++}),this.uuid=Ma(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Fu(s[a].image)):r.push(Fu(s[a]))}else r=Fu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Fu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?uc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(nt("Texture: Unable to serialize Texture."),{})}var bv=0,Uu=new W,Hn=class i extends $i{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=qi,s=qi,r=Vn,a=vs,o=Fi,l=Yn,c=i.DEFAULT_ANISOTROPY,h=bs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:bv++}),this.uuid=Ma(),this.name="",this.source=new ha(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Ee(0,0),this.repeat=new Ee(1,1),this.center=new Ee(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new dt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Uu).x}get height(){return this.source.getSize(Uu).y}get depth(){return this.source.getSize(Uu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){nt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Td)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fr:e.x=e.x-Math.floor(e.x);break;case qi:e.x=e.x<0?0:1;break;case lc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fr:e.y=e.y-Math.floor(e.y);break;case qi:e.y=e.y<0?0:1;break;case lc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=Td;Hn.DEFAULT_ANISOTROPY=1;var Jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],v=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,b=(f+1)/2,C=(g+1)/2,E=(h+d)/4,x=(u+v)/4,w=(p+m)/4;return A>b&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=E/s,r=w/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=w/r),this.set(n,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-v)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this.w=St(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this.w=St(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(St(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},dc=class extends $i{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Vn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Hn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Vn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ha(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends dc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},so=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mn,this.minFilter=Mn,this.wrapR=qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var fc=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mn,this.minFilter=Mn,this.wrapR=qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ct=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,u,d,f,p,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,u,d,f,p,v,m)}set(e,t,n,s,r,a,o,l,c,h,u,d,f,p,v,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=v,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Yr.setFromMatrixColumn(e,0).length(),r=1/Yr.setFromMatrixColumn(e,1).length(),a=1/Yr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=a*h,f=a*u,p=o*h,v=o*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-v*c,t[9]=-o*l,t[2]=v-d*c,t[6]=p+f*c,t[10]=a*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,v=c*u;t[0]=d+v*o,t[4]=p*o-f,t[8]=a*c,t[1]=a*u,t[5]=a*h,t[9]=-o,t[2]=f*o-p,t[6]=v+d*o,t[10]=a*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,v=c*u;t[0]=d-v*o,t[4]=-a*u,t[8]=p+f*o,t[1]=f+p*o,t[5]=a*h,t[9]=v-d*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let d=a*h,f=a*u,p=o*h,v=o*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+v,t[1]=l*u,t[5]=v*c+d,t[9]=f*c-p,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let d=a*l,f=a*c,p=o*l,v=o*c;t[0]=l*h,t[4]=v-d*u,t[8]=p*u+f,t[1]=u,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-v*u}else if(e.order==="XZY"){let d=a*l,f=a*c,p=o*l,v=o*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+v,t[5]=a*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=o*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Mv,e,Sv)}lookAt(e,t,n){let s=this.elements;return ii.subVectors(e,t),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),Ns.crossVectors(n,ii),Ns.lengthSq()===0&&(Math.abs(n.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),Ns.crossVectors(n,ii)),Ns.normalize(),Pl.crossVectors(ii,Ns),s[0]=Ns.x,s[4]=Pl.x,s[8]=ii.x,s[1]=Ns.y,s[5]=Pl.y,s[9]=ii.y,s[2]=Ns.z,s[6]=Pl.z,s[10]=ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],v=n[6],m=n[10],g=n[14],y=n[3],A=n[7],b=n[11],C=n[15],E=s[0],x=s[4],w=s[8],O=s[12],L=s[1],I=s[5],k=s[9],H=s[13],D=s[2],V=s[6],q=s[10],z=s[14],le=s[3],Z=s[7],Q=s[11],ee=s[15];return r[0]=a*E+o*L+l*D+c*le,r[4]=a*x+o*I+l*V+c*Z,r[8]=a*w+o*k+l*q+c*Q,r[12]=a*O+o*H+l*z+c*ee,r[1]=h*E+u*L+d*D+f*le,r[5]=h*x+u*I+d*V+f*Z,r[9]=h*w+u*k+d*q+f*Q,r[13]=h*O+u*H+d*z+f*ee,r[2]=p*E+v*L+m*D+g*le,r[6]=p*x+v*I+m*V+g*Z,r[10]=p*w+v*k+m*q+g*Q,r[14]=p*O+v*H+m*z+g*ee,r[3]=y*E+A*L+b*D+C*le,r[7]=y*x+A*I+b*V+C*Z,r[11]=y*w+A*k+b*q+C*Q,r[15]=y*O+A*H+b*z+C*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],v=e[7],m=e[11],g=e[15],y=l*f-c*d,A=o*f-c*u,b=o*d-l*u,C=a*f-c*h,E=a*d-l*h,x=a*u-o*h;return t*(v*y-m*A+g*b)-n*(p*y-m*C+g*E)+s*(p*A-v*C+g*x)-r*(p*b-v*E+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],v=e[13],m=e[14],g=e[15],y=t*o-n*a,A=t*l-s*a,b=t*c-r*a,C=n*l-s*o,E=n*c-r*o,x=s*c-r*l,w=h*v-u*p,O=h*m-d*p,L=h*g-f*p,I=u*m-d*v,k=u*g-f*v,H=d*g-f*m,D=y*H-A*k+b*I+C*L-E*O+x*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return e[0]=(o*H-l*k+c*I)*V,e[1]=(s*k-n*H-r*I)*V,e[2]=(v*x-m*E+g*C)*V,e[3]=(d*E-u*x-f*C)*V,e[4]=(l*L-a*H-c*O)*V,e[5]=(t*H-s*L+r*O)*V,e[6]=(m*b-p*x-g*A)*V,e[7]=(h*x-d*b+f*A)*V,e[8]=(a*k-o*L+c*w)*V,e[9]=(n*L-t*k-r*w)*V,e[10]=(p*E-v*b+g*y)*V,e[11]=(u*b-h*E-f*y)*V,e[12]=(o*O-a*I-l*w)*V,e[13]=(t*I-n*O+s*w)*V,e[14]=(v*A-p*C-m*y)*V,e[15]=(h*C-u*A+d*y)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,u=o+o,d=r*c,f=r*h,p=r*u,v=a*h,m=a*u,g=o*u,y=l*c,A=l*h,b=l*u,C=n.x,E=n.y,x=n.z;return s[0]=(1-(v+g))*C,s[1]=(f+b)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+g))*E,s[6]=(m+y)*E,s[7]=0,s[8]=(p+A)*x,s[9]=(m-y)*x,s[10]=(1-(d+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),l=Yr.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Ti.copy(this);let c=1/a,h=1/o,u=1/l;return Ti.elements[0]*=c,Ti.elements[1]*=c,Ti.elements[2]*=c,Ti.elements[4]*=h,Ti.elements[5]*=h,Ti.elements[6]*=h,Ti.elements[8]*=u,Ti.elements[9]*=u,Ti.elements[10]*=u,t.setFromRotationMatrix(Ti),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=gi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(l)p=r/(a-r),v=a*r/(a-r);else if(o===gi)p=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===la)p=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=gi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(l)p=1/(a-r),v=a/(a-r);else if(o===gi)p=-2/(a-r),v=-(a+r)/(a-r);else if(o===la)p=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Yr=new W,Ti=new Ct,Mv=new W(0,0,0),Sv=new W(1,1,1),Ns=new W,Pl=new W,ii=new W,ym=new Ct,bm=new Gn,ms=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(St(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-St(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(St(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-St(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(St(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-St(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return ym.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ym,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return bm.setFromEuler(this),this.setFromQuaternion(bm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ms.DEFAULT_ORDER="XYZ";var ro=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},wv=0,Mm=new W,$r=new Gn,ls=new Ct,Il=new W,Wa=new W,Tv=new W,Av=new Gn,Sm=new W(1,0,0),wm=new W(0,1,0),Tm=new W(0,0,1),Am={type:"added"},Ev={type:"removed"},Zr={type:"childadded",child:null},Ou={type:"childremoved",child:null},In=class i extends $i{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:wv++}),this.uuid=Ma(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new W,t=new ms,n=new Gn,s=new W(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ct},normalMatrix:{value:new dt}}),this.matrix=new Ct,this.matrixWorld=new Ct,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ro,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(Sm,e)}rotateY(e){return this.rotateOnAxis(wm,e)}rotateZ(e){return this.rotateOnAxis(Tm,e)}translateOnAxis(e,t){return Mm.copy(e).applyQuaternion(this.quaternion),this.position.add(Mm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Sm,e)}translateY(e){return this.translateOnAxis(wm,e)}translateZ(e){return this.translateOnAxis(Tm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ls.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Il.copy(e):Il.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ls.lookAt(Wa,Il,this.up):ls.lookAt(Il,Wa,this.up),this.quaternion.setFromRotationMatrix(ls),s&&(ls.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(ls),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(lt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Am),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):lt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ev),Ou.child=e,this.dispatchEvent(Ou),Ou.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ls.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ls.multiply(e.parent.matrixWorld)),e.applyMatrix4(ls),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Am),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,e,Tv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,Av,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),u=a(e.shapes),d=a(e.skeletons),f=a(e.animations),p=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};In.DEFAULT_UP=new W(0,1,0);In.DEFAULT_MATRIX_AUTO_UPDATE=!0;In.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ri=class extends In{constructor(){super(),this.isGroup=!0,this.type="Group"}},Cv={type:"move"},ua=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ri,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ri,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ri,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,n),g=this._getHandJoint(c,v);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Cv)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ri;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Ig={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},Ll={h:0,s:0,l:0};function Bu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var mt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=En){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,At.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=At.workingColorSpace){return this.r=e,this.g=t,this.b=n,At.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=At.workingColorSpace){if(e=gv(e,1),t=St(t,0,1),n=St(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=Bu(a,r,e+1/3),this.g=Bu(a,r,e),this.b=Bu(a,r,e-1/3)}return At.colorSpaceToWorking(this,s),this}setStyle(e,t=En){function n(r){r!==void 0&&parseFloat(r)<1&&nt("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:nt("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);nt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=En){let n=Ig[e.toLowerCase()];return n!==void 0?this.setHex(n,t):nt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=fs(e.r),this.g=fs(e.g),this.b=fs(e.b),this}copyLinearToSRGB(e){return this.r=aa(e.r),this.g=aa(e.g),this.b=aa(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=En){return At.workingToColorSpace(Pn.copy(this),e),Math.round(St(Pn.r*255,0,255))*65536+Math.round(St(Pn.g*255,0,255))*256+Math.round(St(Pn.b*255,0,255))}getHexString(e=En){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=At.workingColorSpace){At.workingToColorSpace(Pn.copy(this),t);let n=Pn.r,s=Pn.g,r=Pn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=At.workingColorSpace){return At.workingToColorSpace(Pn.copy(this),t),e.r=Pn.r,e.g=Pn.g,e.b=Pn.b,e}getStyle(e=En){At.workingToColorSpace(Pn.copy(this),e);let t=Pn.r,n=Pn.g,s=Pn.b;return e!==En?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Fs),this.setHSL(Fs.h+e,Fs.s+t,Fs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Fs),e.getHSL(Ll);let n=Lu(Fs.h,Ll.h,t),s=Lu(Fs.s,Ll.s,t),r=Lu(Fs.l,Ll.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Pn=new mt;mt.NAMES=Ig;var ao=class extends In{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ms,this.environmentIntensity=1,this.environmentRotation=new ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ai=new W,cs=new W,ku=new W,hs=new W,Jr=new W,Kr=new W,Em=new W,zu=new W,Vu=new W,Gu=new W,Hu=new Jt,Wu=new Jt,Xu=new Jt,ks=class i{constructor(e=new W,t=new W,n=new W){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ai.subVectors(e,t),s.cross(Ai);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ai.subVectors(s,t),cs.subVectors(n,t),ku.subVectors(e,t);let a=Ai.dot(Ai),o=Ai.dot(cs),l=Ai.dot(ku),c=cs.dot(cs),h=cs.dot(ku),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-o*h)*d,p=(a*h-o*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,hs)===null?!1:hs.x>=0&&hs.y>=0&&hs.x+hs.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,hs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,hs.x),l.addScaledVector(a,hs.y),l.addScaledVector(o,hs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Hu.setScalar(0),Wu.setScalar(0),Xu.setScalar(0),Hu.fromBufferAttribute(e,t),Wu.fromBufferAttribute(e,n),Xu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Hu,r.x),a.addScaledVector(Wu,r.y),a.addScaledVector(Xu,r.z),a}static isFrontFacing(e,t,n,s){return Ai.subVectors(n,t),cs.subVectors(e,t),Ai.cross(cs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ai.subVectors(this.c,this.b),cs.subVectors(this.a,this.b),Ai.cross(cs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;Jr.subVectors(s,n),Kr.subVectors(r,n),zu.subVectors(e,n);let l=Jr.dot(zu),c=Kr.dot(zu);if(l<=0&&c<=0)return t.copy(n);Vu.subVectors(e,s);let h=Jr.dot(Vu),u=Kr.dot(Vu);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(Jr,a);Gu.subVectors(e,r);let f=Jr.dot(Gu),p=Kr.dot(Gu);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return o=c/(c-p),t.copy(n).addScaledVector(Kr,o);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Em.subVectors(r,s),o=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(Em,o);let g=1/(m+v+d);return a=v*g,o=d*g,t.copy(n).addScaledVector(Jr,a).addScaledVector(Kr,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Zi=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ei.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ei.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ei.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Ei):Ei.fromBufferAttribute(r,a),Ei.applyMatrix4(e.matrixWorld),this.expandByPoint(Ei);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Dl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Dl.copy(n.boundingBox)),Dl.applyMatrix4(e.matrixWorld),this.union(Dl)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ei),Ei.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Xa),Nl.subVectors(this.max,Xa),Qr.subVectors(e.a,Xa),jr.subVectors(e.b,Xa),ea.subVectors(e.c,Xa),Us.subVectors(jr,Qr),Os.subVectors(ea,jr),cr.subVectors(Qr,ea);let t=[0,-Us.z,Us.y,0,-Os.z,Os.y,0,-cr.z,cr.y,Us.z,0,-Us.x,Os.z,0,-Os.x,cr.z,0,-cr.x,-Us.y,Us.x,0,-Os.y,Os.x,0,-cr.y,cr.x,0];return!qu(t,Qr,jr,ea,Nl)||(t=[1,0,0,0,1,0,0,0,1],!qu(t,Qr,jr,ea,Nl))?!1:(Fl.crossVectors(Us,Os),t=[Fl.x,Fl.y,Fl.z],qu(t,Qr,jr,ea,Nl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ei).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ei).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},us=[new W,new W,new W,new W,new W,new W,new W,new W],Ei=new W,Dl=new Zi,Qr=new W,jr=new W,ea=new W,Us=new W,Os=new W,cr=new W,Xa=new W,Nl=new W,Fl=new W,hr=new W;function qu(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){hr.fromArray(i,r);let o=s.x*Math.abs(hr.x)+s.y*Math.abs(hr.y)+s.z*Math.abs(hr.z),l=e.dot(hr),c=t.dot(hr),h=n.dot(hr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var un=new W,Ul=new Ee,Rv=0,Ri=class extends $i{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Rv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Tg,this.updateRanges=[],this.gpuType=xi,this.version=0,this._normalizationScale=e!==void 0?Bd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ul.fromBufferAttribute(this,t),Ul.applyMatrix3(e),this.setXY(t,Ul.x,Ul.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)un.fromBufferAttribute(this,t),un.applyMatrix3(e),this.setXYZ(t,un.x,un.y,un.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)un.fromBufferAttribute(this,t),un.applyMatrix4(e),this.setXYZ(t,un.x,un.y,un.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)un.fromBufferAttribute(this,t),un.applyNormalMatrix(e),this.setXYZ(t,un.x,un.y,un.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)un.fromBufferAttribute(this,t),un.transformDirection(e),this.setXYZ(t,un.x,un.y,un.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):xv(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):_v(e,this.array)}};var oo=class extends Ri{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var lo=class extends Ri{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Et=class extends Ri{constructor(e,t,n){super(new Float32Array(e),t,n)}},Pv=new Zi,qa=new W,Yu=new W,zs=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Pv.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;qa.subVectors(e,this.center);let t=qa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(qa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Yu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(qa.copy(e.center).add(Yu)),this.expandByPoint(qa.copy(e.center).sub(Yu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Iv=0,mi=new Ct,$u=new In,ta=new W,si=new Zi,Ya=new Zi,bn=new W,Sn=class i extends $i{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Iv++}),this.uuid=Ma(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(pv(e)?lo:oo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new dt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return mi.makeRotationFromQuaternion(e),this.applyMatrix4(mi),this}rotateX(e){return mi.makeRotationX(e),this.applyMatrix4(mi),this}rotateY(e){return mi.makeRotationY(e),this.applyMatrix4(mi),this}rotateZ(e){return mi.makeRotationZ(e),this.applyMatrix4(mi),this}translate(e,t,n){return mi.makeTranslation(e,t,n),this.applyMatrix4(mi),this}scale(e,t,n){return mi.makeScale(e,t,n),this.applyMatrix4(mi),this}lookAt(e){return $u.lookAt(e),$u.updateMatrix(),this.applyMatrix4($u.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ta).negate(),this.translate(ta.x,ta.y,ta.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Et(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){lt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];si.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&lt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){lt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let n=this.boundingSphere.center;if(si.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];Ya.setFromBufferAttribute(o),this.morphTargetsRelative?(bn.addVectors(si.min,Ya.min),si.expandByPoint(bn),bn.addVectors(si.max,Ya.max),si.expandByPoint(bn)):(si.expandByPoint(Ya.min),si.expandByPoint(Ya.max))}si.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)bn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(bn));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)bn.fromBufferAttribute(o,c),l&&(ta.fromBufferAttribute(e,c),bn.add(ta)),s=Math.max(s,n.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&lt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){lt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new Ri(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)o[O]=new W,l[O]=new W;let h=new W,u=new W,d=new W,f=new Ee,p=new Ee,v=new Ee,m=new W,g=new W;function y(O,L,I){c[O]=c[L]=c[I]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,L),d.fromBufferAttribute(n,I),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,L),v.fromBufferAttribute(r,I),u.sub(h),d.sub(h),p.sub(f),v.sub(f);let k=1/(p.x*v.y-v.x*p.y);isFinite(k)&&(m.copy(u).multiplyScalar(v.y).addScaledVector(d,-p.y).multiplyScalar(k),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(k),o[O].add(m),o[L].add(m),o[I].add(m),l[O].add(g),l[L].add(g),l[I].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let O=0,L=A.length;O<L;++O){let I=A[O],k=I.start,H=I.count;for(let D=k,V=k+H;D<V;D+=3)y(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new W,C=new W,E=new W,x=new W;function w(O){E.fromBufferAttribute(s,O),x.copy(E);let L=o[O];b.copy(L),b.sub(E.multiplyScalar(E.dot(L))).normalize(),C.crossVectors(x,L);let k=C.dot(l[O])<0?-1:1;a.setXYZW(O,b.x,b.y,b.z,k)}for(let O=0,L=n.count;O<L;++O)c[O]&&w(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Ri(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new W,r=new W,a=new W,o=new W,l=new W,c=new W,h=new W,u=new W;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),v=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),a.fromBufferAttribute(t,m),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(n,p),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),o.add(h),l.add(h),c.add(h),n.setXYZ(p,o.x,o.y,o.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),a.fromBufferAttribute(t,d+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,u=o.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let v=0,m=l.length;v<m;v++){o.isInterleavedBufferAttribute?f=l[v]*o.data.stride+o.offset:f=l[v]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new Ri(d,h,u)}if(this.index===null)return nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Zu=new W,Lv=new W,Dv=new dt,Ci=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Zu.subVectors(n,t).cross(Lv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Zu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Dv.getNormalMatrix(e),s=this.coplanarPoint(Zu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Nv=0,Vs=class extends $i{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Nv++}),this.uuid=Ma(),this.name="",this.type="Material",this.blending=va,this.side=Zs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=xd,this.blendDst=_d,this.blendEquation=xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new mt(0,0,0),this.blendAlpha=0,this.depthFunc=oa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=vg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ec,this.stencilZFail=ec,this.stencilZPass=ec,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){nt(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new mt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ci().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ee().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ee().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ds=new W,Ju=new W,Ol=new W,Bl=new W,pc=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ds)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ds.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ds.copy(this.origin).addScaledVector(this.direction,t),ds.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Ju.copy(e).add(t).multiplyScalar(.5),Ol.copy(t).sub(e).normalize(),Bl.copy(this.origin).sub(Ju);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Ol),o=Bl.dot(this.direction),l=-Bl.dot(Ol),c=Bl.lengthSq(),h=Math.abs(1-a*a),u,d,f,p;if(h>0)if(u=a*l-o,d=a*o-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let v=1/h;u*=v,d*=v,f=u*(u+a*d+2*o)+d*(a*u+d+2*l)+c}else d=r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-a*r+o)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(a*r+o)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=a>0?-r:r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ju).addScaledVector(Ol,d),f}intersectSphere(e,t){if(e.radius<0)return null;ds.subVectors(e.center,this.origin);let n=ds.dot(this.direction),s=ds.dot(ds)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,a=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,a=(e.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(o=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ds)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=e.x-a.x,d=e.y-a.y,f=e.z-a.z,p=t.x-a.x,v=t.y-a.y,m=t.z-a.z,g=n.x-a.x,y=n.y-a.y,A=n.z-a.z,b=Math.abs(l),C=Math.abs(c),E=Math.abs(h),x,w,O,L,I,k,H,D,V,q,z,le;if(b>=C&&b>=E?(O=l,k=u,V=p,le=g,l>=0?(x=c,w=h,L=d,I=f,H=v,D=m,q=y,z=A):(x=h,w=c,L=f,I=d,H=m,D=v,q=A,z=y)):C>=E?(O=c,k=d,V=v,le=y,c>=0?(x=h,w=l,L=f,I=u,H=m,D=p,q=A,z=g):(x=l,w=h,L=u,I=f,H=p,D=m,q=g,z=A)):(O=h,k=f,V=m,le=A,h>=0?(x=l,w=c,L=u,I=d,H=p,D=v,q=g,z=y):(x=c,w=l,L=d,I=u,H=v,D=p,q=y,z=g)),O===0)return null;let Z=x/O,Q=w/O,ee=1/O,de=L-Z*k,ce=I-Q*k,j=H-Z*V,ge=D-Q*V,_e=q-Z*le,Le=z-Q*le,Se=_e*ge-Le*j,Ge=de*Le-ce*_e,it=j*ce-ge*de;if(s){if(Se<0||Ge<0||it<0)return null}else if((Se<0||Ge<0||it<0)&&(Se>0||Ge>0||it>0))return null;let Je=Se+Ge+it;if(Je===0)return null;let st=ee*(Se*k+Ge*V+it*le);return(Je>0?st<0:st>0)?null:this.at(st/Je,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Pi=class extends Vs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new mt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=Oc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Cm=new Ct,ur=new pc,kl=new zs,Rm=new W,zl=new W,Vl=new W,Gl=new W,Ku=new W,Hl=new W,Pm=new W,Wl=new W,Ut=class extends In{constructor(e=new Sn,t=new Pi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Hl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],u=r[l];h!==0&&(Ku.fromBufferAttribute(u,e),a?Hl.addScaledVector(Ku,h):Hl.addScaledVector(Ku.sub(t),h))}t.add(Hl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),kl.copy(n.boundingSphere),kl.applyMatrix4(r),ur.copy(e.ray).recast(e.near),!(kl.containsPoint(ur.origin)===!1&&(ur.intersectSphere(kl,Rm)===null||ur.origin.distanceToSquared(Rm)>(e.far-e.near)**2))&&(Cm.copy(r).invert(),ur.copy(e.ray).applyMatrix4(Cm),!(n.boundingBox!==null&&ur.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ur)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let p=0,v=d.length;p<v;p++){let m=d[p],g=a[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(o.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=A;b<C;b+=3){let E=o.getX(b),x=o.getX(b+1),w=o.getX(b+2);s=Xl(this,g,e,n,c,h,u,E,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(o.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let y=o.getX(m),A=o.getX(m+1),b=o.getX(m+2);s=Xl(this,a,e,n,c,h,u,y,A,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let p=0,v=d.length;p<v;p++){let m=d[p],g=a[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,C=A;b<C;b+=3){let E=b,x=b+1,w=b+2;s=Xl(this,g,e,n,c,h,u,E,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let y=m,A=m+1,b=m+2;s=Xl(this,a,e,n,c,h,u,y,A,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Fv(i,e,t,n,s,r,a,o){let l;if(e.side===Xn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===Zs,o),l===null)return null;Wl.copy(o),Wl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Wl);return c<t.near||c>t.far?null:{distance:c,point:Wl.clone(),object:i}}function Xl(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,zl),i.getVertexPosition(l,Vl),i.getVertexPosition(c,Gl);let h=Fv(i,e,t,n,zl,Vl,Gl,Pm);if(h){let u=new W;ks.getBarycoord(Pm,zl,Vl,Gl,u),s&&(h.uv=ks.getInterpolatedAttribute(s,o,l,c,u,new Ee)),r&&(h.uv1=ks.getInterpolatedAttribute(r,o,l,c,u,new Ee)),a&&(h.normal=ks.getInterpolatedAttribute(a,o,l,c,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:l,c,normal:new W,materialIndex:0};ks.getNormal(zl,Vl,Gl,d.normal),h.face=d,h.barycoord=u}return h}var co=class extends Hn{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Mn,h=Mn,u,d){super(null,a,o,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var gs=class extends Ri{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},na=new Ct,Im=new Ct,ql=[],Lm=new Zi,Uv=new Ct,$a=new Ut,Za=new zs,Ii=class extends Ut{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new gs(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Uv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Zi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,na),Lm.copy(e.boundingBox).applyMatrix4(na),this.boundingBox.union(Lm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new zs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,na),Za.copy(e.boundingSphere).applyMatrix4(na),this.boundingSphere.union(Za)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,a=e*r+1;for(let o=0;o<n.length;o++)n[o]=s[a+o]}raycast(e,t){let n=this.matrixWorld,s=this.count;if($a.geometry=this.geometry,$a.material=this.material,$a.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Za.copy(this.boundingSphere),Za.applyMatrix4(n),e.ray.intersectsSphere(Za)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,na),Im.multiplyMatrices(n,na),$a.matrixWorld=Im,$a.raycast(e,ql);for(let a=0,o=ql.length;a<o;a++){let l=ql[a];l.instanceId=r,l.object=this,t.push(l)}ql.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new gs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new co(new Float32Array(s*this.count),s,this.count,Wc,xi));let r=this.morphTexture.source.data.data,a=0;for(let c=0;c<n.length;c++)a+=n[c];let o=this.geometry.morphTargetsRelative?1:1-a,l=s*e;return r[l]=o,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},dr=new zs,Ov=new Ee(.5,.5),Yl=new W,Gs=class{constructor(e=new Ci,t=new Ci,n=new Ci,s=new Ci,r=new Ci,a=new Ci){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=gi,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],v=r[9],m=r[10],g=r[11],y=r[12],A=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-a,f-h,g-p,C-y).normalize(),s[1].setComponents(c+a,f+h,g+p,C+y).normalize(),s[2].setComponents(c+o,f+u,g+v,C+A).normalize(),s[3].setComponents(c-o,f-u,g-v,C-A).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,C-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,C-b).normalize(),t===gi)s[5].setComponents(c+l,f+d,g+m,C+b).normalize();else if(t===la)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(e){dr.center.set(0,0,0);let t=Ov.distanceTo(e.center);return dr.radius=.7071067811865476+t,dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Yl.x=s.normal.x>0?e.max.x:e.min.x,Yl.y=s.normal.y>0?e.max.y:e.min.y,Yl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Yl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Dm=new Ct,mc=class i{constructor(){this.coordinateSystem=gi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Dm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gs),n[s].setFromProjectionMatrix(Dm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Gs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var ho=class extends Hn{constructor(e=[],t=_r,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Hs=class extends Hn{constructor(e,t,n,s,r,a,o,l,c){super(e,t,n,s,r,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var xs=class extends Hn{constructor(e,t,n=Di,s,r,a,o=Mn,l=Mn,c,h=ps,u=1){if(h!==ps&&h!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ha(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},uo=class extends xs{constructor(e,t=Di,n=_r,s,r,a=Mn,o=Mn,l,c=ps){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},fo=class extends Hn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},da=class i extends Sn{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,a,r,0),p("z","y","x",1,-1,n,t,-e,a,r,1),p("x","z","y",1,1,e,n,t,s,a,2),p("x","z","y",1,-1,e,n,-t,s,a,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Et(c,3)),this.setAttribute("normal",new Et(h,3)),this.setAttribute("uv",new Et(u,2));function p(v,m,g,y,A,b,C,E,x,w,O){let L=b/x,I=C/w,k=b/2,H=C/2,D=E/2,V=x+1,q=w+1,z=0,le=0,Z=new W;for(let Q=0;Q<q;Q++){let ee=Q*I-H;for(let de=0;de<V;de++){let ce=de*L-k;Z[v]=ce*y,Z[m]=ee*A,Z[g]=D,c.push(Z.x,Z.y,Z.z),Z[v]=0,Z[m]=0,Z[g]=E>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(de/x),u.push(1-Q/w),z+=1}}for(let Q=0;Q<w;Q++)for(let ee=0;ee<x;ee++){let de=d+ee+V*Q,ce=d+ee+V*(Q+1),j=d+(ee+1)+V*(Q+1),ge=d+(ee+1)+V*Q;l.push(de,ce,ge),l.push(ce,j,ge),le+=6}o.addGroup(f,le,O),f+=le,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var fa=class i extends Sn{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],a=[],o=[],l=[],c=new W,h=new Ee;a.push(0,0,0),o.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),a.push(c.x,c.y,c.z),o.push(0,0,1),h.x=(a[d]/e+1)/2,h.y=(a[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Et(a,3)),this.setAttribute("normal",new Et(o,3)),this.setAttribute("uv",new Et(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},pa=class i extends Sn{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,v=[],m=n/2,g=0;y(),a===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Et(u,3)),this.setAttribute("normal",new Et(d,3)),this.setAttribute("uv",new Et(f,2));function y(){let b=new W,C=new W,E=0,x=(t-e)/n;for(let w=0;w<=r;w++){let O=[],L=w/r,I=L*(t-e)+e;for(let k=0;k<=s;k++){let H=k/s,D=H*l+o,V=Math.sin(D),q=Math.cos(D);C.x=I*V,C.y=-L*n+m,C.z=I*q,u.push(C.x,C.y,C.z),b.set(V,x,q).normalize(),d.push(b.x,b.y,b.z),f.push(H,1-L),O.push(p++)}v.push(O)}for(let w=0;w<s;w++)for(let O=0;O<r;O++){let L=v[O][w],I=v[O+1][w],k=v[O+1][w+1],H=v[O][w+1];(e>0||O!==0)&&(h.push(L,I,H),E+=3),(t>0||O!==r-1)&&(h.push(I,k,H),E+=3)}c.addGroup(g,E,0),g+=E}function A(b){let C=p,E=new Ee,x=new W,w=0,O=b===!0?e:t,L=b===!0?1:-1;for(let k=1;k<=s;k++)u.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let I=p;for(let k=0;k<=s;k++){let D=k/s*l+o,V=Math.cos(D),q=Math.sin(D);x.x=O*q,x.y=m*L,x.z=O*V,u.push(x.x,x.y,x.z),d.push(0,L,0),E.x=V*.5+.5,E.y=q*.5*L+.5,f.push(E.x,E.y),p++}for(let k=0;k<s;k++){let H=C+k,D=I+k;b===!0?h.push(D,D+1,H):h.push(D+1,D,H),w+=3}c.addGroup(g,w,b===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var oi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){nt("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let a=1;a<=e;a++)n=this.getPoint(a/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,a;t?a=t:a=e*n[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=n[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===a)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(a-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=t||(a.isVector2?new Ee:new W);return l.copy(o).sub(a).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new W,s=[],r=[],a=[],o=new W,l=new Ct;for(let f=0;f<=e;f++){let p=f/e;s[f]=this.getTangentAt(p,new W)}r[0]=new W,a[0]=new W;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),o.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),a[f]=a[f-1].clone(),o.crossVectors(s[f-1],s[f]),o.length()>Number.EPSILON){o.normalize();let p=Math.acos(St(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(o,p))}a[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(St(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(o.crossVectors(r[0],r[e]))>0&&(f=-f);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),a[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},ma=class extends oi{constructor(e=0,t=0,n=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(e,t=new Ee){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},gc=class extends ma{constructor(e,t,n,s,r,a){super(e,t,n,n,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function kd(){let i=0,e=0,t=0,n=0;function s(r,a,o,l){i=r,e=o,t=-3*r+3*a-2*o-l,n=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,u){let d=(a-r)/c-(o-r)/(c+h)+(o-a)/h,f=(o-a)/h-(l-a)/(h+u)+(l-o)/u;d*=h,f*=h,s(a,o,d,f)},calc:function(r){let a=r*r,o=a*r;return i+e*r+t*a+n*o}}}var Nm=new W,Fm=new W,Qu=new kd,ju=new kd,ed=new kd,xc=class extends oi{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new W){let n=t,s=this.points,r=s.length,a=(r-(this.closed?0:1))*e,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(Fm.subVectors(s[0],s[1]).add(s[0]),c=Fm);let u=s[o%r],d=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(Nm.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Nm),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),v=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);v<1e-4&&(v=1),p<1e-4&&(p=v),m<1e-4&&(m=v),Qu.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,v,m),ju.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,v,m),ed.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,v,m)}else this.curveType==="catmullrom"&&(Qu.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),ju.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),ed.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Qu.calc(l),ju.calc(l),ed.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new W().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Um(i,e,t,n,s){let r=(n-e)*.5,a=(s-t)*.5,o=i*i,l=i*o;return(2*t-2*n+r+a)*l+(-3*t+3*n-2*r-a)*o+r*i+t}function Bv(i,e){let t=1-i;return t*t*e}function kv(i,e){return 2*(1-i)*i*e}function zv(i,e){return i*i*e}function Qa(i,e,t,n){return Bv(i,e)+kv(i,t)+zv(i,n)}function Vv(i,e){let t=1-i;return t*t*t*e}function Gv(i,e){let t=1-i;return 3*t*t*i*e}function Hv(i,e){return 3*(1-i)*i*i*e}function Wv(i,e){return i*i*i*e}function ja(i,e,t,n,s){return Vv(i,e)+Gv(i,t)+Hv(i,n)+Wv(i,s)}var po=class extends oi{constructor(e=new Ee,t=new Ee,n=new Ee,s=new Ee){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Ee){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(ja(e,s.x,r.x,a.x,o.x),ja(e,s.y,r.y,a.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},_c=class extends oi{constructor(e=new W,t=new W,n=new W,s=new W){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new W){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(ja(e,s.x,r.x,a.x,o.x),ja(e,s.y,r.y,a.y,o.y),ja(e,s.z,r.z,a.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},mo=class extends oi{constructor(e=new Ee,t=new Ee){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Ee){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Ee){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vc=class extends oi{constructor(e=new W,t=new W){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new W){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new W){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},go=class extends oi{constructor(e=new Ee,t=new Ee,n=new Ee){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Ee){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(Qa(e,s.x,r.x,a.x),Qa(e,s.y,r.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},yc=class extends oi{constructor(e=new W,t=new W,n=new W){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new W){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(Qa(e,s.x,r.x,a.x),Qa(e,s.y,r.y,a.y),Qa(e,s.z,r.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},xo=class extends oi{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Ee){let n=t,s=this.points,r=(s.length-1)*e,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],u=s[a>s.length-3?s.length-1:a+2];return n.set(Um(o,l.x,c.x,h.x,u.x),Um(o,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Ee().fromArray(s))}return this}},ad=Object.freeze({__proto__:null,ArcCurve:gc,CatmullRomCurve3:xc,CubicBezierCurve:po,CubicBezierCurve3:_c,EllipseCurve:ma,LineCurve:mo,LineCurve3:vc,QuadraticBezierCurve:go,QuadraticBezierCurve3:yc,SplineCurve:xo}),bc=class extends oi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new ad[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let a=s[r]-n,o=this.curves[r],l=o.getLength(),c=l===0?0:1-a/l;return o.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let a=r[s],o=a.isEllipseCurve?e*2:a.isLineCurve||a.isLineCurve3?1:a.isSplineCurve?e*a.points.length:e,l=a.getPoints(o);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new ad[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},Ws=class extends bc{constructor(e){super(),this.type="Path",this.currentPoint=new Ee,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new mo(this.currentPoint.clone(),new Ee(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new go(this.currentPoint.clone(),new Ee(e,t),new Ee(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,a){let o=new po(this.currentPoint.clone(),new Ee(e,t),new Ee(n,s),new Ee(r,a));return this.curves.push(o),this.currentPoint.set(r,a),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new xo(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,a){let o=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+o,t+l,n,s,r,a),this}absarc(e,t,n,s,r,a){return this.absellipse(e,t,n,n,s,r,a),this}ellipse(e,t,n,s,r,a,o,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,a,o,l),this}absellipse(e,t,n,s,r,a,o,l){let c=new ma(e,t,n,s,r,a,o,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Xs=class extends Ws{constructor(e){super(e),this.uuid=Ma(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new Ws().fromJSON(s))}return this}};function Xv(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=Lg(i,0,s,t,!0),a=[];if(!r||r.next===r.prev)return a;let o,l,c;if(n&&(r=Jv(i,e,r,t)),i.length>80*t){o=i[0],l=i[1];let h=o,u=l;for(let d=t;d<s;d+=t){let f=i[d],p=i[d+1];f<o&&(o=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-o,u-l),c=c!==0?32767/c:0}return _o(r,a,t,o,l,c,0),a}function Lg(i,e,t,n,s){let r;if(s===oy(i,e,t,n)>0)for(let a=e;a<t;a+=n)r=Om(a/n|0,i[a],i[a+1],r);else for(let a=t-n;a>=e;a-=n)r=Om(a/n|0,i[a],i[a+1],r);return r&&ga(r,r.next)&&(yo(r),r=r.next),r}function pr(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(ga(t,t.next)||Qt(t.prev,t,t.next)===0)){if(yo(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function _o(i,e,t,n,s,r,a){if(!i)return;!a&&r&&ty(i,n,s,r);let o=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Yv(i,n,s,r):qv(i)){e.push(l.i,i.i,c.i),yo(i),i=c.next,o=c.next;continue}if(i=c,i===o){a?a===1?(i=$v(pr(i),e),_o(i,e,t,n,s,r,2)):a===2&&Zv(i,e,t,n,s,r):_o(pr(i),e,t,n,s,r,1);break}}}function qv(i){let e=i.prev,t=i,n=i.next;if(Qt(e,t,n)>=0)return!1;let s=e.x,r=t.x,a=n.x,o=e.y,l=t.y,c=n.y,h=Math.min(s,r,a),u=Math.min(o,l,c),d=Math.max(s,r,a),f=Math.max(o,l,c),p=n.next;for(;p!==e;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&Ja(s,o,r,l,a,c,p.x,p.y)&&Qt(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Yv(i,e,t,n){let s=i.prev,r=i,a=i.next;if(Qt(s,r,a)>=0)return!1;let o=s.x,l=r.x,c=a.x,h=s.y,u=r.y,d=a.y,f=Math.min(o,l,c),p=Math.min(h,u,d),v=Math.max(o,l,c),m=Math.max(h,u,d),g=od(f,p,e,t,n),y=od(v,m,e,t,n),A=i.prevZ,b=i.nextZ;for(;A&&A.z>=g&&b&&b.z<=y;){if(A.x>=f&&A.x<=v&&A.y>=p&&A.y<=m&&A!==s&&A!==a&&Ja(o,h,l,u,c,d,A.x,A.y)&&Qt(A.prev,A,A.next)>=0||(A=A.prevZ,b.x>=f&&b.x<=v&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&Ja(o,h,l,u,c,d,b.x,b.y)&&Qt(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;A&&A.z>=g;){if(A.x>=f&&A.x<=v&&A.y>=p&&A.y<=m&&A!==s&&A!==a&&Ja(o,h,l,u,c,d,A.x,A.y)&&Qt(A.prev,A,A.next)>=0)return!1;A=A.prevZ}for(;b&&b.z<=y;){if(b.x>=f&&b.x<=v&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&Ja(o,h,l,u,c,d,b.x,b.y)&&Qt(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function $v(i,e){let t=i;do{let n=t.prev,s=t.next.next;!ga(n,s)&&Ng(n,t,t.next,s)&&vo(n,s)&&vo(s,n)&&(e.push(n.i,t.i,s.i),yo(t),yo(t.next),t=i=s),t=t.next}while(t!==i);return pr(t)}function Zv(i,e,t,n,s,r){let a=i;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&sy(a,o)){let l=Fg(a,o);a=pr(a,a.next),l=pr(l,l.next),_o(a,e,t,n,s,r,0),_o(l,e,t,n,s,r,0);return}o=o.next}a=a.next}while(a!==i)}function Jv(i,e,t,n){let s=[];for(let r=0,a=e.length;r<a;r++){let o=e[r]*n,l=r<a-1?e[r+1]*n:i.length,c=Lg(i,o,l,n,!1);c===c.next&&(c.steiner=!0),s.push(iy(c))}s.sort(Kv);for(let r=0;r<s.length;r++)t=Qv(s[r],t);return t}function Kv(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function Qv(i,e){let t=jv(i,e);if(!t)return e;let n=Fg(t,i);return pr(n,n.next),pr(t,t.next)}function jv(i,e){let t=e,n=i.x,s=i.y,r=-1/0,a;if(ga(i,t))return t;do{if(ga(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,a=t.x<t.next.x?t:t.next,u===n))return a}t=t.next}while(t!==e);if(!a)return null;let o=a,l=a.x,c=a.y,h=1/0;t=a;do{if(n>=t.x&&t.x>=l&&n!==t.x&&Dg(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);vo(t,i)&&(u<h||u===h&&(t.x>a.x||t.x===a.x&&ey(a,t)))&&(a=t,h=u)}t=t.next}while(t!==o);return a}function ey(i,e){return Qt(i.prev,i,e.prev)<0&&Qt(e.next,i,i.next)<0}function ty(i,e,t,n){let s=i;do s.z===0&&(s.z=od(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,ny(s)}function ny(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let a=n,o=0;for(let c=0;c<t&&(o++,a=a.nextZ,!!a);c++);let l=t;for(;o>0||l>0&&a;)o!==0&&(l===0||!a||n.z<=a.z)?(s=n,n=n.nextZ,o--):(s=a,a=a.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=a}r.nextZ=null,t*=2}while(e>1);return i}function od(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function iy(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function Dg(i,e,t,n,s,r,a,o){return(s-a)*(e-o)>=(i-a)*(r-o)&&(i-a)*(n-o)>=(t-a)*(e-o)&&(t-a)*(r-o)>=(s-a)*(n-o)}function Ja(i,e,t,n,s,r,a,o){return!(i===a&&e===o)&&Dg(i,e,t,n,s,r,a,o)}function sy(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!ry(i,e)&&(vo(i,e)&&vo(e,i)&&ay(i,e)&&(Qt(i.prev,i,e.prev)||Qt(i,e.prev,e))||ga(i,e)&&Qt(i.prev,i,i.next)>0&&Qt(e.prev,e,e.next)>0)}function Qt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function ga(i,e){return i.x===e.x&&i.y===e.y}function Ng(i,e,t,n){let s=Zl(Qt(i,e,t)),r=Zl(Qt(i,e,n)),a=Zl(Qt(t,n,i)),o=Zl(Qt(t,n,e));return!!(s!==r&&a!==o||s===0&&$l(i,t,e)||r===0&&$l(i,n,e)||a===0&&$l(t,i,n)||o===0&&$l(t,e,n))}function $l(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function Zl(i){return i>0?1:i<0?-1:0}function ry(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&Ng(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function vo(i,e){return Qt(i.prev,i,i.next)<0?Qt(i,e,i.next)>=0&&Qt(i,i.prev,e)>=0:Qt(i,e,i.prev)<0||Qt(i,i.next,e)<0}function ay(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function Fg(i,e){let t=ld(i.i,i.x,i.y),n=ld(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function Om(i,e,t,n){let s=ld(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function yo(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function ld(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function oy(i,e,t,n){let s=0;for(let r=e,a=t-n;r<t;r+=n)s+=(i[a]-i[r])*(i[r+1]+i[a+1]),a=r;return s}var cd=class{static triangulate(e,t,n=2){return Xv(e,t,n)}},Yi=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];Bm(e),km(n,e);let a=e.length;t.forEach(Bm);for(let l=0;l<t.length;l++)s.push(a),a+=t[l].length,km(n,t[l]);let o=cd.triangulate(n,s);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}};function Bm(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function km(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var bo=class i extends Sn{constructor(e=new Xs([new Ee(.5,.5),new Ee(-.5,.5),new Ee(-.5,-.5),new Ee(.5,-.5)]),t={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:e,options:t},e=Array.isArray(e)?e:[e];let n=this,s=[],r=[];for(let o=0,l=e.length;o<l;o++){let c=e[o];a(c)}this.setAttribute("position",new Et(s,3)),this.setAttribute("uv",new Et(r,2)),this.computeVertexNormals();function a(o){let l=[],c=t.curveSegments!==void 0?t.curveSegments:12,h=t.steps!==void 0?t.steps:1,u=t.depth!==void 0?t.depth:1,d=t.bevelEnabled!==void 0?t.bevelEnabled:!0,f=t.bevelThickness!==void 0?t.bevelThickness:.2,p=t.bevelSize!==void 0?t.bevelSize:f-.1,v=t.bevelOffset!==void 0?t.bevelOffset:0,m=t.bevelSegments!==void 0?t.bevelSegments:3,g=t.extrudePath,y=t.UVGenerator!==void 0?t.UVGenerator:ly,A,b=!1,C,E,x,w;if(g){A=g.getSpacedPoints(h),b=!0,d=!1;let re=g.isCatmullRomCurve3?g.closed:!1;C=g.computeFrenetFrames(h,re),E=new W,x=new W,w=new W}d||(m=0,f=0,p=0,v=0);let O=o.extractPoints(c),L=O.shape,I=O.holes;if(!Yi.isClockWise(L)){L=L.reverse();for(let re=0,ve=I.length;re<ve;re++){let xe=I[re];Yi.isClockWise(xe)&&(I[re]=xe.reverse())}}function H(re){let xe=10000000000000001e-36,Be=re[0];for(let De=1;De<=re.length;De++){let et=De%re.length,ke=re[et],pt=ke.x-Be.x,ut=ke.y-Be.y,xt=pt*pt+ut*ut,F=Math.max(Math.abs(ke.x),Math.abs(ke.y),Math.abs(Be.x),Math.abs(Be.y)),be=xe*F*F;if(xt<=be){re.splice(et,1),De--;continue}Be=ke}}H(L),I.forEach(H);let D=I.length,V=L;for(let re=0;re<D;re++){let ve=I[re];L=L.concat(ve)}function q(re,ve,xe){return ve||lt("ExtrudeGeometry: vec does not exist"),re.clone().addScaledVector(ve,xe)}let z=L.length;function le(re,ve,xe){let Be,De,et,ke=re.x-ve.x,pt=re.y-ve.y,ut=xe.x-re.x,xt=xe.y-re.y,F=ke*ke+pt*pt,be=ke*xt-pt*ut;if(Math.abs(be)>Number.EPSILON){let Xe=Math.sqrt(F),ct=Math.sqrt(ut*ut+xt*xt),we=ve.x-pt/Xe,Dt=ve.y+ke/Xe,$e=xe.x-xt/ct,je=xe.y+ut/ct,R=(($e-we)*xt-(je-Dt)*ut)/(ke*xt-pt*ut);Be=we+ke*R-re.x,De=Dt+pt*R-re.y;let M=Be*Be+De*De;if(M<=2)return new Ee(Be,De);et=Math.sqrt(M/2)}else{let Xe=!1;ke>Number.EPSILON?ut>Number.EPSILON&&(Xe=!0):ke<-Number.EPSILON?ut<-Number.EPSILON&&(Xe=!0):Math.sign(pt)===Math.sign(xt)&&(Xe=!0),Xe?(Be=-pt,De=ke,et=Math.sqrt(F)):(Be=ke,De=pt,et=Math.sqrt(F/2))}return new Ee(Be/et,De/et)}let Z=[];for(let re=0,ve=V.length,xe=ve-1,Be=re+1;re<ve;re++,xe++,Be++)xe===ve&&(xe=0),Be===ve&&(Be=0),Z[re]=le(V[re],V[xe],V[Be]);let Q=[],ee,de=Z.concat();for(let re=0,ve=D;re<ve;re++){let xe=I[re];ee=[];for(let Be=0,De=xe.length,et=De-1,ke=Be+1;Be<De;Be++,et++,ke++)et===De&&(et=0),ke===De&&(ke=0),ee[Be]=le(xe[Be],xe[et],xe[ke]);Q.push(ee),de=de.concat(ee)}let ce;if(m===0)ce=Yi.triangulateShape(V,I);else{let re=[],ve=[];for(let xe=0;xe<m;xe++){let Be=xe/m,De=f*Math.cos(Be*Math.PI/2),et=p*Math.sin(Be*Math.PI/2)+v;for(let ke=0,pt=V.length;ke<pt;ke++){let ut=q(V[ke],Z[ke],et);Ge(ut.x,ut.y,-De),Be===0&&re.push(ut)}for(let ke=0,pt=D;ke<pt;ke++){let ut=I[ke];ee=Q[ke];let xt=[];for(let F=0,be=ut.length;F<be;F++){let Xe=q(ut[F],ee[F],et);Ge(Xe.x,Xe.y,-De),Be===0&&xt.push(Xe)}Be===0&&ve.push(xt)}}ce=Yi.triangulateShape(re,ve)}let j=ce.length,ge=p+v;for(let re=0;re<z;re++){let ve=d?q(L[re],de[re],ge):L[re];b?(x.copy(C.normals[0]).multiplyScalar(ve.x),E.copy(C.binormals[0]).multiplyScalar(ve.y),w.copy(A[0]).add(x).add(E),Ge(w.x,w.y,w.z)):Ge(ve.x,ve.y,0)}for(let re=1;re<=h;re++)for(let ve=0;ve<z;ve++){let xe=d?q(L[ve],de[ve],ge):L[ve];b?(x.copy(C.normals[re]).multiplyScalar(xe.x),E.copy(C.binormals[re]).multiplyScalar(xe.y),w.copy(A[re]).add(x).add(E),Ge(w.x,w.y,w.z)):Ge(xe.x,xe.y,u/h*re)}for(let re=m-1;re>=0;re--){let ve=re/m,xe=f*Math.cos(ve*Math.PI/2),Be=p*Math.sin(ve*Math.PI/2)+v;for(let De=0,et=V.length;De<et;De++){let ke=q(V[De],Z[De],Be);Ge(ke.x,ke.y,u+xe)}for(let De=0,et=I.length;De<et;De++){let ke=I[De];ee=Q[De];for(let pt=0,ut=ke.length;pt<ut;pt++){let xt=q(ke[pt],ee[pt],Be);b?Ge(xt.x,xt.y+A[h-1].y,A[h-1].x+xe):Ge(xt.x,xt.y,u+xe)}}}_e(),Le();function _e(){let re=s.length/3;if(d){let ve=0,xe=z*ve;for(let Be=0;Be<j;Be++){let De=ce[Be];it(De[2]+xe,De[1]+xe,De[0]+xe)}ve=h+m*2,xe=z*ve;for(let Be=0;Be<j;Be++){let De=ce[Be];it(De[0]+xe,De[1]+xe,De[2]+xe)}}else{for(let ve=0;ve<j;ve++){let xe=ce[ve];it(xe[2],xe[1],xe[0])}for(let ve=0;ve<j;ve++){let xe=ce[ve];it(xe[0]+z*h,xe[1]+z*h,xe[2]+z*h)}}n.addGroup(re,s.length/3-re,0)}function Le(){let re=s.length/3,ve=0;Se(V,ve),ve+=V.length;for(let xe=0,Be=I.length;xe<Be;xe++){let De=I[xe];Se(De,ve),ve+=De.length}n.addGroup(re,s.length/3-re,1)}function Se(re,ve){let xe=re.length;for(;--xe>=0;){let Be=xe,De=xe-1;De<0&&(De=re.length-1);for(let et=0,ke=h+m*2;et<ke;et++){let pt=z*et,ut=z*(et+1),xt=ve+Be+pt,F=ve+De+pt,be=ve+De+ut,Xe=ve+Be+ut;Je(xt,F,be,Xe)}}}function Ge(re,ve,xe){l.push(re),l.push(ve),l.push(xe)}function it(re,ve,xe){st(re),st(ve),st(xe);let Be=s.length/3,De=y.generateTopUV(n,s,Be-3,Be-2,Be-1);tt(De[0]),tt(De[1]),tt(De[2])}function Je(re,ve,xe,Be){st(re),st(ve),st(Be),st(ve),st(xe),st(Be);let De=s.length/3,et=y.generateSideWallUV(n,s,De-6,De-3,De-2,De-1);tt(et[0]),tt(et[1]),tt(et[3]),tt(et[1]),tt(et[2]),tt(et[3])}function st(re){s.push(l[re*3+0]),s.push(l[re*3+1]),s.push(l[re*3+2])}function tt(re){r.push(re.x),r.push(re.y)}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes,n=this.parameters.options;return cy(t,n,e)}static fromJSON(e,t){let n=[];for(let r=0,a=e.shapes.length;r<a;r++){let o=t[e.shapes[r]];n.push(o)}let s=e.options.extrudePath;return s!==void 0&&(e.options.extrudePath=new ad[s.type]().fromJSON(s)),new i(n,e.options)}},ly={generateTopUV:function(i,e,t,n,s){let r=e[t*3],a=e[t*3+1],o=e[n*3],l=e[n*3+1],c=e[s*3],h=e[s*3+1];return[new Ee(r,a),new Ee(o,l),new Ee(c,h)]},generateSideWallUV:function(i,e,t,n,s,r){let a=e[t*3],o=e[t*3+1],l=e[t*3+2],c=e[n*3],h=e[n*3+1],u=e[n*3+2],d=e[s*3],f=e[s*3+1],p=e[s*3+2],v=e[r*3],m=e[r*3+1],g=e[r*3+2];return Math.abs(o-h)<Math.abs(a-c)?[new Ee(a,1-l),new Ee(c,1-u),new Ee(d,1-p),new Ee(v,1-g)]:[new Ee(o,1-l),new Ee(h,1-u),new Ee(f,1-p),new Ee(m,1-g)]}};function cy(i,e,t){if(t.shapes=[],Array.isArray(i))for(let n=0,s=i.length;n<s;n++){let r=i[n];t.shapes.push(r.uuid)}else t.shapes.push(i.uuid);return t.options=Object.assign({},e),e.extrudePath!==void 0&&(t.options.extrudePath=e.extrudePath.toJSON()),t}var Li=class i extends Sn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,u=e/o,d=t/l,f=[],p=[],v=[],m=[];for(let g=0;g<h;g++){let y=g*d-a;for(let A=0;A<c;A++){let b=A*u-r;p.push(b,-y,0),v.push(0,0,1),m.push(A/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<o;y++){let A=y+c*g,b=y+c*(g+1),C=y+1+c*(g+1),E=y+1+c*g;f.push(A,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new Et(p,3)),this.setAttribute("normal",new Et(v,3)),this.setAttribute("uv",new Et(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},_s=class i extends Sn{constructor(e=.5,t=1,n=32,s=1,r=0,a=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:a},n=Math.max(3,n),s=Math.max(1,s);let o=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new W,p=new Ee;for(let v=0;v<=s;v++){for(let m=0;m<=n;m++){let g=r+m/n*a;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/t+1)/2,p.y=(f.y/t+1)/2,h.push(p.x,p.y)}u+=d}for(let v=0;v<s;v++){let m=v*(n+1);for(let g=0;g<n;g++){let y=g+m,A=y,b=y+n+1,C=y+n+2,E=y+1;o.push(A,b,E),o.push(b,C,E)}}this.setIndex(o),this.setAttribute("position",new Et(l,3)),this.setAttribute("normal",new Et(c,3)),this.setAttribute("uv",new Et(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}},Mo=class i extends Sn{constructor(e=new Xs([new Ee(0,.5),new Ee(-.5,-.5),new Ee(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],a=[],o=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(o,l,h),o+=l,l=0;this.setIndex(n),this.setAttribute("position",new Et(s,3)),this.setAttribute("normal",new Et(r,3)),this.setAttribute("uv",new Et(a,2));function c(h){let u=s.length/3,d=h.extractPoints(t),f=d.shape,p=d.holes;Yi.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,g=p.length;m<g;m++){let y=p[m];Yi.isClockWise(y)===!0&&(p[m]=y.reverse())}let v=Yi.triangulateShape(f,p);for(let m=0,g=p.length;m<g;m++){let y=p[m];f=f.concat(y)}for(let m=0,g=f.length;m<g;m++){let y=f[m];s.push(y.x,y.y,0),r.push(0,0,1),a.push(y.x,y.y)}for(let m=0,g=v.length;m<g;m++){let y=v[m],A=y[0]+u,b=y[1]+u,C=y[2]+u;n.push(A,b,C),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return hy(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let a=t[e.shapes[s]];n.push(a)}return new i(n,e.curveSegments)}};function hy(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var mr=class i extends Sn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(a+o,Math.PI),c=0,h=[],u=new W,d=new W,f=[],p=[],v=[],m=[];for(let g=0;g<=n;g++){let y=[],A=g/n,b=a+A*o,C=e*Math.cos(b),E=Math.sqrt(e*e-C*C),x=0;g===0&&a===0?x=.5/t:g===n&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let O=w/t,L=s+O*r;u.x=-E*Math.cos(L),u.y=C,u.z=E*Math.sin(L),p.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),m.push(O+x,1-A),y.push(c++)}h.push(y)}for(let g=0;g<n;g++)for(let y=0;y<t;y++){let A=h[g][y+1],b=h[g][y],C=h[g+1][y],E=h[g+1][y+1];(g!==0||a>0)&&f.push(A,b,E),(g!==n-1||l<Math.PI)&&f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new Et(p,3)),this.setAttribute("normal",new Et(v,3)),this.setAttribute("uv",new Et(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function yr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(zm(s))s.isRenderTargetTexture?(nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(zm(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Dn(i){let e={};for(let t=0;t<i.length;t++){let n=yr(i[t]);for(let s in n)e[s]=n[s]}return e}function zm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function uy(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function zd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:At.workingColorSpace}var Ug={clone:yr,merge:Dn},dy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,fy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wn=class extends Vs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=dy,this.fragmentShader=fy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=yr(e.uniforms),this.uniformsGroups=uy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new mt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ee().fromArray(s.value);break;case"v3":this.uniforms[n].value=new W().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new dt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ct().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Mc=class extends Wn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var li=class extends Vs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new mt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new mt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=wh,this.normalScale=new Ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ms,this.combine=Oc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Sc=class extends Vs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},wc=class extends Vs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ia(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Jl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var qs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Tc=class extends qs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:id,endingEnd:id}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case sd:r=e,o=2*t-n;break;case rd:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case sd:a=e,l=2*n-t;break;case rd:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,m=v*p,g=-d*m+2*d*v-d*p,y=(1+d)*m+(-1.5-2*d)*v+(-.5+d)*p+1,A=(-1-f)*m+(1.5+f)*v+.5*p,b=f*m-f*v;for(let C=0;C!==o;++C)r[C]=g*a[h+C]+y*a[c+C]+A*a[l+C]+b*a[u+C];return r}},Ac=class extends qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==o;++d)r[d]=a[c+d]*u+a[l+d]*h;return r}},Ec=class extends qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Cc=class extends qs{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),v=1-p;for(let m=0;m!==o;++m)r[m]=a[c+m]*v+a[l+m]*p;return r}let d=o*2,f=e-1;for(let p=0;p!==o;++p){let v=a[c+p],m=a[l+p],g=f*d+p*2,y=u[g],A=u[g+1],b=e*d+p*2,C=h[b],E=h[b+1],x=my(n,t,y,C,s);r[p]=Og(x,v,A,E,m)}return r}};function Og(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function py(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function my(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=Og(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=py(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var ci=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ia(t,this.TimeBufferType),this.values=ia(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:ia(e.times,Array),values:ia(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Jl(e.settings)&&(n.settings={inTangents:ia(e.settings.inTangents,Array),outTangents:ia(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ac(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Cc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case eo:t=this.InterpolantFactoryMethodDiscrete;break;case cc:t=this.InterpolantFactoryMethodLinear;break;case jl:t=this.InterpolantFactoryMethodSmooth;break;case nd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return nt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return eo;case this.InterpolantFactoryMethodLinear:return cc;case this.InterpolantFactoryMethodSmooth:return jl;case this.InterpolantFactoryMethodBezier:return nd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Jl(this.settings)&&(Vm(this.settings.inTangents,e),Vm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Jl(this.settings)&&(Gm(this.settings.inTangents,e),Gm(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(lt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(lt("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){lt("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){lt("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&mv(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){lt("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===jl,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let u=o*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let v=t[u+p];if(v!==t[d+p]||v!==t[f+p]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let u=o*n,d=a*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Jl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Vm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Gm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=cc;var Ys=class extends ci{constructor(e,t,n){super(e,t,n)}};Ys.prototype.ValueTypeName="bool";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=eo;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var Rc=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};Rc.prototype.ValueTypeName="color";var Pc=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};Pc.prototype.ValueTypeName="number";var Ic=class extends qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)Gn.slerpFlat(r,0,a,c-o,a,c,l);return r}},So=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Ic(this.times,this.values,this.getValueSize(),e)}};So.prototype.ValueTypeName="quaternion";So.prototype.InterpolantFactoryMethodSmooth=void 0;var $s=class extends ci{constructor(e,t,n){super(e,t,n)}};$s.prototype.ValueTypeName="string";$s.prototype.ValueBufferType=Array;$s.prototype.DefaultInterpolation=eo;$s.prototype.InterpolantFactoryMethodLinear=void 0;$s.prototype.InterpolantFactoryMethodSmooth=void 0;var Lc=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};Lc.prototype.ValueTypeName="vector";var Dc=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Bg=new Dc,Nc=class{constructor(e){this.manager=e!==void 0?e:Bg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Nc.DEFAULT_MATERIAL_NAME="__DEFAULT";var wo=class extends In{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new mt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},To=class extends wo{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.groundColor=new mt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},td=new Ct,Hm=new W,Wm=new W,Fc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ee(512,512),this.mapType=Yn,this.map=null,this.mapPass=null,this.matrix=new Ct,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new Ee(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Hm.setFromMatrixPosition(e.matrixWorld),t.position.copy(Hm),Wm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Wm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){td.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(td,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===la||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(td)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Kl=new W,Ql=new Gn,Xi=new W,Ao=class extends In{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ct,this.projectionMatrix=new Ct,this.projectionMatrixInverse=new Ct,this.coordinateSystem=gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Kl,Ql,Xi),Xi.x===1&&Xi.y===1&&Xi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Kl,Ql,Xi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Kl,Ql,Xi),Xi.x===1&&Xi.y===1&&Xi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Kl,Ql,Xi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Bs=new W,Xm=new Ee,qm=new Ee,zn=class extends Ao{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=hc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Iu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return hc*2*Math.atan(Math.tan(Iu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Bs.x,Bs.y).multiplyScalar(-e/Bs.z),Bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Bs.x,Bs.y).multiplyScalar(-e/Bs.z)}getViewSize(e,t){return this.getViewBounds(e,Xm,qm),t.subVectors(qm,Xm)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Iu*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Eo=class extends Ao{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},hd=class extends Fc{constructor(){super(new Eo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Co=class extends wo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.target=new In,this.shadow=new hd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var sa=-90,ra=1,xa=class extends In{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new zn(sa,ra,e,t);s.layers=this.layers,this.add(s);let r=new zn(sa,ra,e,t);r.layers=this.layers,this.add(r);let a=new zn(sa,ra,e,t);a.layers=this.layers,this.add(a);let o=new zn(sa,ra,e,t);o.layers=this.layers,this.add(o);let l=new zn(sa,ra,e,t);l.layers=this.layers,this.add(l);let c=new zn(sa,ra,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===gi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===la)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Uc=class extends zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Vd="\\[\\]\\.:\\/",gy=new RegExp("["+Vd+"]","g"),Gd="[^"+Vd+"]",xy="[^"+Vd.replace("\\.","")+"]",_y=/((?:WC+[\/:])*)/.source.replace("WC",Gd),vy=/(WCOD+)?/.source.replace("WCOD",xy),yy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gd),by=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gd),My=new RegExp("^"+_y+vy+yy+by+"$"),Sy=["material","materials","bones","map"],ud=class{constructor(e,t,n){let s=n||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},$t=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(gy,"")}static parseTrackName(e){let t=My.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Sy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){lt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){lt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){lt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){lt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){lt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;lt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=ud;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var ZT=new Float32Array(1);var dd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function Hd(i,e,t,n){let s=wy(n);switch(t){case Pd:return i*e;case Wc:return i*e/s.components*s.byteLength;case Xc:return i*e/s.components*s.byteLength;case Js:return i*e*2/s.components*s.byteLength;case qc:return i*e*2/s.components*s.byteLength;case Id:return i*e*3/s.components*s.byteLength;case Fi:return i*e*4/s.components*s.byteLength;case Yc:return i*e*4/s.components*s.byteLength;case Lo:case Do:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case No:case Fo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Zc:case Kc:return Math.max(i,16)*Math.max(e,8)/4;case $c:case Jc:return Math.max(i,8)*Math.max(e,8)/2;case Qc:case jc:case th:case nh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case eh:case Uo:case ih:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case ah:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case oh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case lh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case ch:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case hh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case uh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case dh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case ph:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case mh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case gh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case _h:case vh:case yh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case bh:case Mh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Oo:case Sh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function wy(i){switch(i){case Yn:case Ad:return{byteLength:1,components:1};case ba:case Ed:case Ni:return{byteLength:2,components:1};case Gc:case Hc:return{byteLength:2,components:4};case Di:case Vc:case xi:return{byteLength:4,components:1};case Cd:case Rd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function a0(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Ay(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function n(o,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,o),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],v=u[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let v=u[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var Ey=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Cy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Ry=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Py=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Iy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ly=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Dy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Ny=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Fy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Uy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Oy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,By=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ky=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,zy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Vy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Gy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Hy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Wy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Xy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,qy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Yy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,$y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Zy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Jy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Ky=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Qy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,jy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,eb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,tb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,nb="gl_FragColor = linearToOutputTexel( gl_FragColor );",ib=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,sb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,rb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ab=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,ob=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,lb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,cb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,hb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ub=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,db=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,fb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,pb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,mb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,gb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,xb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,_b=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,vb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,yb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,bb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Mb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Sb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,wb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Tb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Ab=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Eb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Cb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Rb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Pb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ib=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Lb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Db=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Nb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Fb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ub=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ob=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Bb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,kb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,zb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Vb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Gb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Hb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Wb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Xb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,qb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,$b=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Zb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Jb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Kb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Qb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,jb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,eM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,tM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,nM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,iM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,sM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,rM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,aM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,oM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,lM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,cM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,hM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,uM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,dM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,fM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,pM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,mM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,gM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,xM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,_M=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,vM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,yM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,bM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,MM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,SM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,wM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,TM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,AM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,EM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,CM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,RM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,IM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,DM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,NM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,FM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,UM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,OM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,kM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,VM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,GM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,XM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,YM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,$M=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ZM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,JM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,KM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,tS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,nS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,iS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,rS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,vt={alphahash_fragment:Ey,alphahash_pars_fragment:Cy,alphamap_fragment:Ry,alphamap_pars_fragment:Py,alphatest_fragment:Iy,alphatest_pars_fragment:Ly,aomap_fragment:Dy,aomap_pars_fragment:Ny,batching_pars_vertex:Fy,batching_vertex:Uy,begin_vertex:Oy,beginnormal_vertex:By,bsdfs:ky,iridescence_fragment:zy,bumpmap_pars_fragment:Vy,clipping_planes_fragment:Gy,clipping_planes_pars_fragment:Hy,clipping_planes_pars_vertex:Wy,clipping_planes_vertex:Xy,color_fragment:qy,color_pars_fragment:Yy,color_pars_vertex:$y,color_vertex:Zy,common:Jy,defaultnormal_vertex:Ky,displacementmap_pars_vertex:Qy,displacementmap_vertex:jy,emissivemap_fragment:eb,emissivemap_pars_fragment:tb,colorspace_fragment:nb,colorspace_pars_fragment:ib,envmap_fragment:sb,envmap_common_pars_fragment:rb,envmap_pars_fragment:ab,envmap_pars_vertex:ob,envmap_physical_pars_fragment:_b,envmap_vertex:lb,fog_vertex:cb,fog_pars_vertex:hb,fog_fragment:ub,fog_pars_fragment:db,gradientmap_pars_fragment:fb,lightmap_pars_fragment:pb,lights_lambert_fragment:mb,lights_lambert_pars_fragment:gb,lights_pars_begin:xb,lights_toon_fragment:vb,lights_toon_pars_fragment:yb,lights_phong_fragment:bb,lights_phong_pars_fragment:Mb,lights_physical_fragment:Sb,lights_physical_pars_fragment:wb,lights_fragment_begin:Tb,lights_fragment_maps:Ab,lights_fragment_end:Eb,lightprobes_pars_fragment:Cb,logdepthbuf_fragment:Rb,logdepthbuf_pars_fragment:Pb,logdepthbuf_pars_vertex:Ib,logdepthbuf_vertex:Lb,map_fragment:Db,map_pars_fragment:Nb,map_particle_fragment:Fb,map_particle_pars_fragment:Ub,metalnessmap_fragment:Ob,metalnessmap_pars_fragment:Bb,morphinstance_vertex:kb,morphcolor_vertex:zb,morphnormal_vertex:Vb,morphtarget_pars_vertex:Gb,morphtarget_vertex:Hb,normal_fragment_begin:Wb,normal_fragment_maps:Xb,normal_pars_fragment:qb,normal_pars_vertex:Yb,normal_vertex:$b,normalmap_pars_fragment:Zb,clearcoat_normal_fragment_begin:Jb,clearcoat_normal_fragment_maps:Kb,clearcoat_pars_fragment:Qb,iridescence_pars_fragment:jb,opaque_fragment:eM,packing:tM,premultiplied_alpha_fragment:nM,project_vertex:iM,dithering_fragment:sM,dithering_pars_fragment:rM,roughnessmap_fragment:aM,roughnessmap_pars_fragment:oM,shadowmap_pars_fragment:lM,shadowmap_pars_vertex:cM,shadowmap_vertex:hM,shadowmask_pars_fragment:uM,skinbase_vertex:dM,skinning_pars_vertex:fM,skinning_vertex:pM,skinnormal_vertex:mM,specularmap_fragment:gM,specularmap_pars_fragment:xM,tonemapping_fragment:_M,tonemapping_pars_fragment:vM,transmission_fragment:yM,transmission_pars_fragment:bM,uv_pars_fragment:MM,uv_pars_vertex:SM,uv_vertex:wM,worldpos_vertex:TM,background_vert:AM,background_frag:EM,backgroundCube_vert:CM,backgroundCube_frag:RM,cube_vert:PM,cube_frag:IM,depth_vert:LM,depth_frag:DM,distance_vert:NM,distance_frag:FM,equirect_vert:UM,equirect_frag:OM,linedashed_vert:BM,linedashed_frag:kM,meshbasic_vert:zM,meshbasic_frag:VM,meshlambert_vert:GM,meshlambert_frag:HM,meshmatcap_vert:WM,meshmatcap_frag:XM,meshnormal_vert:qM,meshnormal_frag:YM,meshphong_vert:$M,meshphong_frag:ZM,meshphysical_vert:JM,meshphysical_frag:KM,meshtoon_vert:QM,meshtoon_frag:jM,points_vert:eS,points_frag:tS,shadow_vert:nS,shadow_frag:iS,sprite_vert:sS,sprite_frag:rS},Oe={common:{diffuse:{value:new mt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new dt}},envmap:{envMap:{value:null},envMapRotation:{value:new dt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new dt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new dt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new dt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new dt},normalScale:{value:new Ee(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new dt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new dt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new dt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new dt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new mt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new mt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0},uvTransform:{value:new dt}},sprite:{diffuse:{value:new mt(16777215)},opacity:{value:1},center:{value:new Ee(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}}},Qi={basic:{uniforms:Dn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.fog]),vertexShader:vt.meshbasic_vert,fragmentShader:vt.meshbasic_frag},lambert:{uniforms:Dn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new mt(0)},envMapIntensity:{value:1}}]),vertexShader:vt.meshlambert_vert,fragmentShader:vt.meshlambert_frag},phong:{uniforms:Dn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new mt(0)},specular:{value:new mt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:vt.meshphong_vert,fragmentShader:vt.meshphong_frag},standard:{uniforms:Dn([Oe.common,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.roughnessmap,Oe.metalnessmap,Oe.fog,Oe.lights,{emissive:{value:new mt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag},toon:{uniforms:Dn([Oe.common,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.gradientmap,Oe.fog,Oe.lights,{emissive:{value:new mt(0)}}]),vertexShader:vt.meshtoon_vert,fragmentShader:vt.meshtoon_frag},matcap:{uniforms:Dn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,{matcap:{value:null}}]),vertexShader:vt.meshmatcap_vert,fragmentShader:vt.meshmatcap_frag},points:{uniforms:Dn([Oe.points,Oe.fog]),vertexShader:vt.points_vert,fragmentShader:vt.points_frag},dashed:{uniforms:Dn([Oe.common,Oe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:vt.linedashed_vert,fragmentShader:vt.linedashed_frag},depth:{uniforms:Dn([Oe.common,Oe.displacementmap]),vertexShader:vt.depth_vert,fragmentShader:vt.depth_frag},normal:{uniforms:Dn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,{opacity:{value:1}}]),vertexShader:vt.meshnormal_vert,fragmentShader:vt.meshnormal_frag},sprite:{uniforms:Dn([Oe.sprite,Oe.fog]),vertexShader:vt.sprite_vert,fragmentShader:vt.sprite_frag},background:{uniforms:{uvTransform:{value:new dt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:vt.background_vert,fragmentShader:vt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new dt}},vertexShader:vt.backgroundCube_vert,fragmentShader:vt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:vt.cube_vert,fragmentShader:vt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:vt.equirect_vert,fragmentShader:vt.equirect_frag},distance:{uniforms:Dn([Oe.common,Oe.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:vt.distance_vert,fragmentShader:vt.distance_frag},shadow:{uniforms:Dn([Oe.lights,Oe.fog,{color:{value:new mt(0)},opacity:{value:1}}]),vertexShader:vt.shadow_vert,fragmentShader:vt.shadow_frag}};Qi.physical={uniforms:Dn([Qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new dt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new dt},clearcoatNormalScale:{value:new Ee(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new dt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new dt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new dt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new dt},sheen:{value:0},sheenColor:{value:new mt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new dt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new dt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new dt},transmissionSamplerSize:{value:new Ee},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new dt},attenuationDistance:{value:0},attenuationColor:{value:new mt(0)},specularColor:{value:new mt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new dt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new dt},anisotropyVector:{value:new Ee},anisotropyMap:{value:null},anisotropyMapTransform:{value:new dt}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag};var Th={r:0,b:0,g:0},aS=new Ct,o0=new dt;o0.set(-1,0,0,0,1,0,0,0,1);function oS(i,e,t,n,s,r){let a=new mt(0),o=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let b=y.backgroundBlurriness>0;A=e.get(A,b)}return A}function p(y){let A=!1,b=f(y);b===null?m(a,o):b&&b.isColor&&(m(b,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,A){let b=f(A);b&&b.isCubeTexture?(c===void 0&&(c=new Ut(new da(1,1,1),new Wn({name:"BackgroundCubeMaterial",uniforms:yr(Qi.backgroundCube.uniforms),vertexShader:Qi.backgroundCube.vertexShader,fragmentShader:Qi.backgroundCube.fragmentShader,side:Xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(aS.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(o0),c.material.toneMapped=At.getTransfer(b.colorSpace)!==Ft,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ut(new Li(2,2),new Wn({name:"BackgroundMaterial",uniforms:yr(Qi.background.uniforms),vertexShader:Qi.background.vertexShader,fragmentShader:Qi.background.fragmentShader,side:Zs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=At.getTransfer(b.colorSpace)!==Ft,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,A){y.getRGB(Th,zd(i)),t.buffers.color.setClear(Th.r,Th.g,Th.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,A=1){a.set(y),o=A,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,m(a,o)},render:p,addToRenderList:v,dispose:g}}function lS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(I,k,H,D,V){let q=!1,z=u(I,D,H,k);r!==z&&(r=z,c(r.object)),q=f(I,D,H,V),q&&p(I,D,H,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,b(I,k,H,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(I){return i.bindVertexArray(I)}function h(I){return i.deleteVertexArray(I)}function u(I,k,H,D){let V=D.wireframe===!0,q=n[k.id];q===void 0&&(q={},n[k.id]=q);let z=I.isInstancedMesh===!0?I.id:0,le=q[z];le===void 0&&(le={},q[z]=le);let Z=le[H.id];Z===void 0&&(Z={},le[H.id]=Z);let Q=Z[V];return Q===void 0&&(Q=d(l()),Z[V]=Q),Q}function d(I){let k=[],H=[],D=[];for(let V=0;V<t;V++)k[V]=0,H[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:H,attributeDivisors:D,object:I,attributes:{},index:null}}function f(I,k,H,D){let V=r.attributes,q=k.attributes,z=0,le=H.getAttributes();for(let Z in le)if(le[Z].location>=0){let ee=V[Z],de=q[Z];if(de===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),ee===void 0||ee.attribute!==de||de&&ee.data!==de.data)return!0;z++}return r.attributesNum!==z||r.index!==D}function p(I,k,H,D){let V={},q=k.attributes,z=0,le=H.getAttributes();for(let Z in le)if(le[Z].location>=0){let ee=q[Z];ee===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(ee=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(ee=I.instanceColor));let de={};de.attribute=ee,ee&&ee.data&&(de.data=ee.data),V[Z]=de,z++}r.attributes=V,r.attributesNum=z,r.index=D}function v(){let I=r.newAttributes;for(let k=0,H=I.length;k<H;k++)I[k]=0}function m(I){g(I,0)}function g(I,k){let H=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;H[I]=1,D[I]===0&&(i.enableVertexAttribArray(I),D[I]=1),V[I]!==k&&(i.vertexAttribDivisor(I,k),V[I]=k)}function y(){let I=r.newAttributes,k=r.enabledAttributes;for(let H=0,D=k.length;H<D;H++)k[H]!==I[H]&&(i.disableVertexAttribArray(H),k[H]=0)}function A(I,k,H,D,V,q,z){z===!0?i.vertexAttribIPointer(I,k,H,V,q):i.vertexAttribPointer(I,k,H,D,V,q)}function b(I,k,H,D){v();let V=D.attributes,q=H.getAttributes(),z=k.defaultAttributeValues;for(let le in q){let Z=q[le];if(Z.location>=0){let Q=V[le];if(Q===void 0&&(le==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),le==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ee=Q.normalized,de=Q.itemSize,ce=e.get(Q);if(ce===void 0)continue;let j=ce.buffer,ge=ce.type,_e=ce.bytesPerElement,Le=ge===i.INT||ge===i.UNSIGNED_INT||Q.gpuType===Vc;if(Q.isInterleavedBufferAttribute){let Se=Q.data,Ge=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,it=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Je=0;Je<Z.locationSize;Je++)g(Z.location+Je,Se.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Je=0;Je<Z.locationSize;Je++)m(Z.location+Je);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Je=0;Je<Z.locationSize;Je++)A(Z.location+Je,de/Z.locationSize,ge,ee,Ge*_e,(it+de/Z.locationSize*Je)*_e,Le)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<Z.locationSize;Se++)g(Z.location+Se,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<Z.locationSize;Se++)m(Z.location+Se);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Se=0;Se<Z.locationSize;Se++)A(Z.location+Se,de/Z.locationSize,ge,ee,de*_e,de/Z.locationSize*Se*_e,Le)}}else if(z!==void 0){let ee=z[le];if(ee!==void 0)switch(ee.length){case 2:i.vertexAttrib2fv(Z.location,ee);break;case 3:i.vertexAttrib3fv(Z.location,ee);break;case 4:i.vertexAttrib4fv(Z.location,ee);break;default:i.vertexAttrib1fv(Z.location,ee)}}}}y()}function C(){O();for(let I in n){let k=n[I];for(let H in k){let D=k[H];for(let V in D){let q=D[V];for(let z in q)h(q[z].object),delete q[z];delete D[V]}}delete n[I]}}function E(I){if(n[I.id]===void 0)return;let k=n[I.id];for(let H in k){let D=k[H];for(let V in D){let q=D[V];for(let z in q)h(q[z].object),delete q[z];delete D[V]}}delete n[I.id]}function x(I){for(let k in n){let H=n[k];for(let D in H){let V=H[D];if(V[I.id]===void 0)continue;let q=V[I.id];for(let z in q)h(q[z].object),delete q[z];delete V[I.id]}}}function w(I){for(let k in n){let H=n[k],D=I.isInstancedMesh===!0?I.id:0,V=H[D];if(V!==void 0){for(let q in V){let z=V[q];for(let le in z)h(z[le].object),delete z[le];delete V[q]}delete H[D],Object.keys(H).length===0&&delete n[k]}}}function O(){L(),a=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:O,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function cS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function hS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==Fi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let w=x===Ni&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Yn&&x!==xi&&!w&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(nt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:b,maxSamples:C,samples:E}}function uS(i){let e=this,t=null,n=0,s=!1,r=!1,a=new Ci,o=new dt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let y=r?0:n,A=y*4,b=g.clippingState||null;l.value=b,b=h(p,d,A,f);for(let C=0;C!==A;++C)b[C]=t[C];g.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let v=u!==null?u.length:0,m=null;if(v!==0){if(m=l.value,p!==!0||m===null){let g=f+v*4,y=d.matrixWorldInverse;o.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let A=0,b=f;A!==v;++A,b+=4)a.copy(u[A]).applyMatrix4(y,o),a.normal.toArray(m,b),m[b+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}var zo=class extends ai{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ho(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new da(5,5,5),r=new Wn({name:"CubemapFromEquirect",uniforms:yr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Xn,blending:gr});r.uniforms.tEquirect.value=t;let a=new Ut(s,r),o=t.minFilter;return t.minFilter===vs&&(t.minFilter=Vn),new xa(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},kg=256,dS=3,fS=20,l0=256,c0=16,pS=3,mS=new W,gS=new mt,Eh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xa(1,10,null),this._boxMesh=new Ut(new da(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=mS}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(gS));let m=new xa(n,s,h);return m.position.copy(o),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Gg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Vg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(kg,Pg(e))}_fromTexture(e,t){e.mapping===_r||e.mapping===ya?this._setSize(e.image.length===0?kg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=zg(e,!1,!1),n=Math.log2(e)-dS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=zg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===_r||e.mapping===ya?(this._cubemapMaterial===null&&(this._cubemapMaterial=Gg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Vg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=xS(),this._integrationMaterial=_S());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/c0);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-pS)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(l0*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=vS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function zg(i,e,t){return new zo(i,{minFilter:vs,generateMipmaps:e,type:Ni,colorSpace:to,depthBuffer:t})}function Vo(i,e,t){return new Wn({name:i,uniforms:e,vertexShader:vt.cube_vert,fragmentShader:t,side:Xn,blending:gr,depthTest:!1,depthWrite:!1})}function xS(){return Vo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${l0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function _S(){return Vo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:c0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function vS(){return Vo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${fS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Vg(){return Vo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Gg(){return Vo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function yS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?a(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Bc||f===kc)if(e.has(d)){let p=e.get(d).texture;return o(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let v=new zo(p.height);return v.fromEquirectangularTexture(i,d),e.set(d,v),d.addEventListener("dispose",c),o(v.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Bc||f===kc,v=f===_r||f===ya;if(p||v){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Eh(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||v&&y&&l(y)?(n===null&&(n=new Eh(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function o(d,f){return f===Bc?d.mapping=_r:f===kc&&(d.mapping=ya),d}function l(d){let f=0,p=6;for(let v=0;v<p;v++)d[v]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function bS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ka("WebGLRenderer: "+n+" extension not supported."),s}}}function MS(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(p=>delete s[p]);function o(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",o),delete s[p.id],a.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),t.memory.geometries++),v}function h(p){let v=p.attributes;for(let m in v)e.update(v[m],i.ARRAY_BUFFER)}function u(p){let v=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=v!==null?v.array.length:m.array.length/3-1,A=m.count>=65535?lo:oo,b=new A(Math.ceil(y/3)*6,1),C=b.array;if(v!==null){let x=v.array;g=v.version;for(let w=0,O=0;w<y;w+=3){let L=x[w+0],I=x[w+1],k=x[w+2];C[O++]=L,C[O++]=I,C[O++]=I,C[O++]=k,C[O++]=k,C[O++]=L}}else{g=m.version;for(let x=0,w=0;x<y;x+=3){let O=x+0,L=x+1,I=x+2;C[w++]=O,C[w++]=L,C[w++]=L,C[w++]=I,C[w++]=I,C[w++]=O}}b.version=g;let E=r.get(p);E&&e.remove(E),r.set(p,b)}function d(p){let v=r.get(p);if(v){let m=p.index;m!==null&&v.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function SS(i,e,t){let n;function s(u){n=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*a),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*a,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let m=0;m<f;m++)v+=d[m];t.update(v,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function wS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:lt("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function TS(i,e,t){let n=new WeakMap,s=new Jt;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==u){let O=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=o.morphAttributes.position!==void 0,p=o.morphAttributes.normal!==void 0,v=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],y=o.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),v===!0&&(A=3);let b=o.attributes.position.count*A,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let E=new Float32Array(b*C*4*u),x=new so(E,b,C,u);x.type=xi,x.needsUpdate=!0;let w=A*4;for(let L=0;L<u;L++){let I=m[L],k=g[L],H=y[L],D=b*C*4*L;for(let V=0;V<I.count;V++){let q=V*w;f===!0&&(s.fromBufferAttribute(I,V),E[D+q+0]=s.x,E[D+q+1]=s.y,E[D+q+2]=s.z,E[D+q+3]=0),p===!0&&(s.fromBufferAttribute(k,V),E[D+q+4]=s.x,E[D+q+5]=s.y,E[D+q+6]=s.z,E[D+q+7]=0),v===!0&&(s.fromBufferAttribute(H,V),E[D+q+8]=s.x,E[D+q+9]=s.y,E[D+q+10]=s.z,E[D+q+11]=H.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new Ee(b,C)},n.set(o,d),o.addEventListener("dispose",O)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function AS(i,e,t,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var ES={[vd]:"LINEAR_TONE_MAPPING",[yd]:"REINHARD_TONE_MAPPING",[bd]:"CINEON_TONE_MAPPING",[Md]:"ACES_FILMIC_TONE_MAPPING",[wd]:"AGX_TONE_MAPPING",[Po]:"NEUTRAL_TONE_MAPPING",[Sd]:"CUSTOM_TONE_MAPPING"};function CS(i,e,t,n,s,r){let a=new ai(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Sn;h.setAttribute("position",new Et([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Et([0,2,0,0,2,0],2));let u=new Mc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ut(h,u),f=new Eo(-1,1,1,-1,0,1),p=null,v=null,m=!1,g,y=null,A=[],b=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),l!==null&&l.setSize(C,E);for(let x=0;x<A.length;x++){let w=A[x];w.setSize&&w.setSize(C,E)}},this.setEffects=function(C){A=C,b=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new ai(E,x,{type:Ni,depthBuffer:!1,stencilBuffer:!1}),l=new ai(E,x,{type:Ni,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&A.some(O=>O.needsDepthTexture===!0);w!==(a.depthTexture!==null)&&(w===!0&&c===null&&(c=new xs(E,x),r===!0&&(c.format=ys,c.type=vr)),a.dispose(),a.depthTexture=w?c:null,a.resolveDepthBuffer=w,a.storeMultisampledDepthBuffer=w);for(let O=0;O<A.length;O++){let L=A[O];L.setSize&&L.setSize(E,x),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===Ji&&A.length===0)return!1;if(y=E,E!==null){let x=E.width,w=E.height;(a.width!==x||a.height!==w)&&this.setSize(x,w)}return b===!1&&C.setRenderTarget(a),g=C.toneMapping,C.toneMapping=Ji,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=g,m=!0;let x=a,w=o;for(let O=0;O<A.length;O++){let L=A[O];L.enabled!==!1&&(L.render(C,w,x,E),L.needsSwap!==!1&&(x=w,w=w===o?l:o))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,u.defines={},At.getTransfer(p)===Ft&&(u.defines.SRGB_TRANSFER="");let O=ES[v];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var h0=new Hn,u0=new xs(1,1),d0=new uo(1),f0=new so,p0=new fc,m0=new ho,Hg=[],Wg=[],Xg=new Float32Array(16),qg=new Float32Array(9),Yg=new Float32Array(4);function wa(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Hg[s];if(r===void 0&&(r=new Float32Array(s),Hg[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function gn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Rh(i,e){let t=Wg[e];t===void 0&&(t=new Int32Array(e),Wg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function RS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function PS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2fv(this.addr,e),gn(t,e)}}function IS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(mn(t,e))return;i.uniform3fv(this.addr,e),gn(t,e)}}function LS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4fv(this.addr,e),gn(t,e)}}function DS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;Yg.set(n),i.uniformMatrix2fv(this.addr,!1,Yg),gn(t,n)}}function NS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;qg.set(n),i.uniformMatrix3fv(this.addr,!1,qg),gn(t,n)}}function FS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;Xg.set(n),i.uniformMatrix4fv(this.addr,!1,Xg),gn(t,n)}}function US(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function OS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2iv(this.addr,e),gn(t,e)}}function BS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;i.uniform3iv(this.addr,e),gn(t,e)}}function kS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4iv(this.addr,e),gn(t,e)}}function zS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function VS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2uiv(this.addr,e),gn(t,e)}}function GS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;i.uniform3uiv(this.addr,e),gn(t,e)}}function HS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4uiv(this.addr,e),gn(t,e)}}function Ph(i){return i.version===0&&(i.compareFunction=Nd,i.needsUpdate=!0),i}function WS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ph(u0):r=h0,t.setTexture2D(e||r,s)}function XS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||p0,s)}function qS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ph(d0):r=m0,t.setTextureCube(e||r,s)}function YS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||f0,s)}function $S(i){switch(i){case 5126:return RS;case 35664:return PS;case 35665:return IS;case 35666:return LS;case 35674:return DS;case 35675:return NS;case 35676:return FS;case 5124:case 35670:return US;case 35667:case 35671:return OS;case 35668:case 35672:return BS;case 35669:case 35673:return kS;case 5125:return zS;case 36294:return VS;case 36295:return GS;case 36296:return HS;case 35678:case 36198:case 36298:case 36306:case 35682:return WS;case 35679:case 36299:case 36307:return XS;case 35680:case 36300:case 36308:case 36293:return qS;case 36289:case 36303:case 36311:case 36292:return YS}}function ZS(i,e){i.uniform1fv(this.addr,e)}function JS(i,e){let t=wa(e,this.size,2);i.uniform2fv(this.addr,t)}function KS(i,e){let t=wa(e,this.size,3);i.uniform3fv(this.addr,t)}function QS(i,e){let t=wa(e,this.size,4);i.uniform4fv(this.addr,t)}function jS(i,e){let t=wa(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function ew(i,e){let t=wa(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function tw(i,e){let t=wa(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function nw(i,e){i.uniform1iv(this.addr,e)}function iw(i,e){i.uniform2iv(this.addr,e)}function sw(i,e){i.uniform3iv(this.addr,e)}function rw(i,e){i.uniform4iv(this.addr,e)}function aw(i,e){i.uniform1uiv(this.addr,e)}function ow(i,e){i.uniform2uiv(this.addr,e)}function lw(i,e){i.uniform3uiv(this.addr,e)}function cw(i,e){i.uniform4uiv(this.addr,e)}function hw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Ph(u0):a=h0;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function uw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||p0,r[a])}function dw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Ph(d0):a=m0;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function fw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||f0,r[a])}function pw(i){switch(i){case 5126:return ZS;case 35664:return JS;case 35665:return KS;case 35666:return QS;case 35674:return jS;case 35675:return ew;case 35676:return tw;case 5124:case 35670:return nw;case 35667:case 35671:return iw;case 35668:case 35672:return sw;case 35669:case 35673:return rw;case 5125:return aw;case 36294:return ow;case 36295:return lw;case 36296:return cw;case 35678:case 36198:case 36298:case 36306:case 35682:return hw;case 35679:case 36299:case 36307:return uw;case 35680:case 36300:case 36308:case 36293:return dw;case 36289:case 36303:case 36311:case 36292:return fw}}var qd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=$S(t.type)}},Yd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=pw(t.type)}},$d=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},Wd=/(\w+)(\])?(\[|\.)?/g;function $g(i,e){i.seq.push(e),i.map[e.id]=e}function mw(i,e,t){let n=i.name,s=n.length;for(Wd.lastIndex=0;;){let r=Wd.exec(n),a=Wd.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){$g(t,c===void 0?new qd(o,i,e):new Yd(o,i,e));break}else{let u=t.map[o];u===void 0&&(u=new $d(o),$g(t,u)),t=u}}}var Sa=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);mw(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Zg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var gw=37297,xw=0;function _w(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Jg=new dt;function vw(i){At._getMatrix(Jg,At.workingColorSpace,i);let e=`mat3( ${Jg.elements.map(t=>t.toFixed(4))} )`;switch(At.getTransfer(i)){case no:return[e,"LinearTransferOETF"];case Ft:return[e,"sRGBTransferOETF"];default:return nt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Kg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+_w(i.getShaderSource(e),o)}else return r}function yw(i,e){let t=vw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var bw={[vd]:"Linear",[yd]:"Reinhard",[bd]:"Cineon",[Md]:"ACESFilmic",[wd]:"AgX",[Po]:"Neutral",[Sd]:"Custom"};function Mw(i,e){let t=bw[e];return t===void 0?(nt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new W;function Sw(){At.getLuminanceCoefficients(Ah);let i=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function ww(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ko).join(`
`)}function Tw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Aw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function ko(i){return i!==""}function Qg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function jg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Ew=/^[ \t]*#include +<([\w\d./]+)>/gm;function Zd(i){return i.replace(Ew,Cw)}function Cw(i,e){let t=vt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Zd(t)}var Rw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function e0(i){return i.replace(Rw,Pw)}function Pw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function t0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Iw={[Ro]:"SHADOWMAP_TYPE_PCF",[_a]:"SHADOWMAP_TYPE_VSM"};function Lw(i){return Iw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Dw={[ya]:"ENVMAP_MODE_REFRACTION"};function Nw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Dw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Fw={[Oc]:"ENVMAP_BLENDING_MULTIPLY",[pg]:"ENVMAP_BLENDING_MIX",[mg]:"ENVMAP_BLENDING_ADD"};function Uw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Fw[i.combine]||"ENVMAP_BLENDING_NONE"}function Ow(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=Lw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Nw(t),u=Uw(t),d=ww(t),f=Tw(r),p=s.createProgram(),v,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(ko).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(ko).join(`
`),m.length>0&&(m+=`
`)):(v=[t0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ko).join(`
`),m=[t0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ji?"#define TONE_MAPPING":"",t.toneMapping!==Ji?vt.tonemapping_pars_fragment:"",t.toneMapping!==Ji?Mw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",vt.colorspace_pars_fragment,yw("linearToOutputTexel",t.outputColorSpace),Sw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ko).join(`
`)),a=Zd(a),a=Qg(a,t),a=jg(a,t),o=Zd(o),o=Qg(o,t),o=jg(o,t),a=e0(a),o=e0(o),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===Ud?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ud?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+v+a,A=g+m+o,b=Zg(s,s.VERTEX_SHADER,y),C=Zg(s,s.FRAGMENT_SHADER,A);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(L){if(i.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(b)||"",H=s.getShaderInfoLog(C)||"",D=I.trim(),V=k.trim(),q=H.trim(),z=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,C);else{let Z=Kg(s,b,"vertex"),Q=Kg(s,C,"fragment");lt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+Z+`
`+Q)}else D!==""?nt("WebGLProgram: Program Info Log:",D):(V===""||q==="")&&(le=!1);le&&(L.diagnostics={runnable:z,programLog:D,vertexShader:{log:V,prefix:v},fragmentShader:{log:q,prefix:m}})}s.deleteShader(b),s.deleteShader(C),x=new Sa(s,p),w=Aw(s,p)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(p,gw)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=xw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var Bw=0,Jd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Kd(e),t.set(e,n)),n}},Kd=class{constructor(e){this.id=Bw++,this.code=e,this.usedTimes=0}};function kw(i){return i===Js||i===Uo||i===Oo}function zw(i,e,t,n,s,r){let a=new ro,o=new Jd,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,w,O,L,I,k){let H=L.fog,D=I.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?L.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||V,q),le=d[x.type],Z=n.precision;x.precision!==null&&(Z=n.getMaxPrecision(x.precision),Z!==x.precision&&nt("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ee=Q!==void 0?Q.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.color!==void 0&&(de=3);let ce,j,ge,_e;if(le){let Ne=Qi[le];ce=Ne.vertexShader,j=Ne.fragmentShader}else{ce=x.vertexShader,j=x.fragmentShader;let Ne=o.getVertexShaderStage(x),gt=o.getFragmentShaderStage(x);o.update(x,Ne,gt),ge=Ne.id,_e=gt.id}let Le=i.getRenderTarget(),Se=i.state.buffers.depth.getReversed(),Ge=I.isInstancedMesh===!0,it=I.isBatchedMesh===!0,Je=!!x.map,st=!!x.matcap,tt=!!z,re=tt&&z.isPMREMTexture===!0,ve=!!x.aoMap,xe=!!x.lightMap,Be=!!x.bumpMap&&x.wireframe===!1,De=!!x.normalMap,et=!!x.displacementMap,ke=!!x.emissiveMap,pt=!!x.metalnessMap,ut=!!x.roughnessMap,xt=x.anisotropy>0,F=x.clearcoat>0,be=x.diffuseRoughness>0,Xe=x.dispersion>0,ct=x.retroreflectivity>0,we=x.iridescence>0,Dt=x.sheen>0,$e=x.transmission>0,je=xt&&!!x.anisotropyMap,R=F&&!!x.clearcoatMap,M=F&&!!x.clearcoatNormalMap,X=F&&!!x.clearcoatRoughnessMap,ue=be&&!!x.diffuseRoughnessMap,ae=we&&!!x.iridescenceMap,Me=we&&!!x.iridescenceThicknessMap,Te=Dt&&!!x.sheenColorMap,te=Dt&&!!x.sheenRoughnessMap,ie=!!x.specularMap,me=!!x.specularColorMap,U=!!x.specularIntensityMap,se=$e&&!!x.transmissionMap,ne=$e&&!!x.thicknessMap,Re=!!x.gradientMap,ye=!!x.alphaMap,Ce=x.alphaTest>0,Ke=!!x.alphaHash,at=!!x.extensions,he=Ji;x.toneMapped&&(Le===null||Le.isXRRenderTarget===!0)&&(he=i.toneMapping);let qe=re?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ot={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:ce,fragmentShader:j,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:_e,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:it,batchingColor:it&&I._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&I.instanceColor!==null,instancingMorph:Ge&&I.morphTexture!==null,outputColorSpace:Le===null?i.outputColorSpace:Le.isXRRenderTarget===!0?Le.texture.colorSpace:At.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Je,matcap:st,envMap:tt,envMapMode:tt&&z.mapping,envMapPMREM:re,envMapMaxLod:re?qe.length-1:null,envMapSize:re?qe[0].width:null,aoMap:ve,lightMap:xe,bumpMap:Be,normalMap:De,displacementMap:et,emissiveMap:ke,normalMapObjectSpace:De&&x.normalMapType===_g,normalMapTangentSpace:De&&x.normalMapType===wh,packedNormalMap:De&&x.normalMapType===wh&&kw(x.normalMap.format),metalnessMap:pt,roughnessMap:ut,anisotropy:xt,anisotropyMap:je,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:be,diffuseRoughnessMap:ue,dispersion:Xe,retroreflection:ct,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:Me,sheen:Dt,sheenColorMap:Te,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:U,transmission:$e,transmissionMap:se,thicknessMap:ne,gradientMap:Re,opaque:x.transparent===!1&&x.blending===va&&x.alphaToCoverage===!1,alphaMap:ye,alphaTest:Ce,alphaHash:Ke,combine:x.combine,mapUv:Je&&f(x.map.channel),aoMapUv:ve&&f(x.aoMap.channel),lightMapUv:xe&&f(x.lightMap.channel),bumpMapUv:Be&&f(x.bumpMap.channel),normalMapUv:De&&f(x.normalMap.channel),displacementMapUv:et&&f(x.displacementMap.channel),emissiveMapUv:ke&&f(x.emissiveMap.channel),metalnessMapUv:pt&&f(x.metalnessMap.channel),roughnessMapUv:ut&&f(x.roughnessMap.channel),anisotropyMapUv:je&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:Me&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:Te&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:ie&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:U&&f(x.specularIntensityMap.channel),transmissionMapUv:se&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:ye&&f(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(De||xt),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Je||ye),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&De===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Se,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(Ne=>Ne.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Je&&x.map.isVideoTexture===!0&&At.getTransfer(x.map.colorSpace)===Ft,decodeVideoTextureEmissive:ke&&x.emissiveMap.isVideoTexture===!0&&At.getTransfer(x.emissiveMap.colorSpace)===Ft,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ln,flipSided:x.side===Xn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:at&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(at&&x.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ot.vertexUv1s=l.has(1),ot.vertexUv2s=l.has(2),ot.vertexUv3s=l.has(3),l.clear(),ot}function v(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)w.push(O),w.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(m(w,x),g(w,x),w.push(i.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function m(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function g(x,w){a.disableAll(),w.instancing&&a.enable(0),w.instancingColor&&a.enable(1),w.instancingMorph&&a.enable(2),w.matcap&&a.enable(3),w.envMap&&a.enable(4),w.normalMapObjectSpace&&a.enable(5),w.normalMapTangentSpace&&a.enable(6),w.clearcoat&&a.enable(7),w.iridescence&&a.enable(8),w.alphaTest&&a.enable(9),w.vertexColors&&a.enable(10),w.vertexAlphas&&a.enable(11),w.vertexUv1s&&a.enable(12),w.vertexUv2s&&a.enable(13),w.vertexUv3s&&a.enable(14),w.vertexTangents&&a.enable(15),w.anisotropy&&a.enable(16),w.alphaHash&&a.enable(17),w.batching&&a.enable(18),w.dispersion&&a.enable(19),w.retroreflection&&a.enable(24),w.diffuseRoughness&&a.enable(25),w.batchingColor&&a.enable(20),w.gradientMap&&a.enable(21),w.packedNormalMap&&a.enable(22),w.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),w.numLightProbeGrids>0&&a.enable(22),w.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function y(x){let w=d[x.type],O;if(w){let L=Qi[w];O=Ug.clone(L.uniforms)}else O=x.uniforms;return O}function A(x,w){let O=h.get(w);return O!==void 0?++O.usedTimes:(O=new Ow(i,w,x,s),c.push(O),h.set(w,O)),O}function b(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){o.remove(x)}function E(){o.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:A,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:E}}function Vw(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Gw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function n0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function i0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,p,v,m,g){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:a(d),groupOrder:v,renderOrder:d.renderOrder,z:m,group:g},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=a(d),y.groupOrder=v,y.renderOrder=d.renderOrder,y.z=m,y.group=g),e++,y}function l(d,f,p,v,m,g,y){y.reversedDepth===!0&&(m=-m);let A=o(d,f,p,v,m,g);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):t.push(A)}function c(d,f,p,v,m,g){let y=o(d,f,p,v,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||Gw),n.length>1&&n.sort(f||n0),s.length>1&&s.sort(f||n0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Hw(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new i0,i.set(n,[a])):s>=r.length?(a=new i0,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function Ww(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new mt};break;case"SpotLight":t={position:new W,direction:new W,color:new mt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new mt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new mt,groundColor:new mt};break;case"RectAreaLight":t={color:new mt,position:new W,halfWidth:new W,halfHeight:new W};break}return i[e.id]=t,t}}}function Xw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ee,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var qw=0;function Yw(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function $w(i){let e=new Ww,t=Xw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new W);let s=new W,r=new Ct,a=new Ct;function o(c){let h=0,u=0,d=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let f=0,p=0,v=0,m=0,g=0,y=0,A=0,b=0,C=0,E=0,x=0,w=0,O=0,L=0;c.sort(Yw);for(let k=0,H=c.length;k<H;k++){let D=c[k],V=D.color,q=D.intensity,z=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Js?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=V.r*q,u+=V.g*q,d+=V.b*q;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(D.sh.coefficients[Z],q);L++}else if(D.isSunLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=ee,n.sunShadowMap[p]=le;let de=Q.getViewportCount();for(let ce=0;ce<de;ce++)n.sunShadowMatrix[v+ce]=Q.getMatrix(ce),n.sunShadowCascade[v+ce]=Q._cascadeData[ce];v+=de,p++}n.sun[f]=Z,f++}else if(D.isDirectionalLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.directionalShadow[m]=ee,n.directionalShadowMap[m]=le,n.directionalShadowMatrix[m]=D.shadow.matrix,C++}n.directional[m]=Z,m++}else if(D.isSpotLight){let Z=e.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(V).multiplyScalar(q),Z.distance=z,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,n.spot[y]=Z;let Q=D.shadow;if(D.map&&(n.spotLightMap[w]=D.map,w++,Q.updateMatrices(D),D.castShadow&&O++),n.spotLightMatrix[y]=Q.matrix,D.castShadow){let ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.spotShadow[y]=ee,n.spotShadowMap[y]=le,x++}y++}else if(D.isRectAreaLight){let Z=e.get(D);Z.color.copy(V).multiplyScalar(q),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),n.rectArea[A]=Z,A++}else if(D.isPointLight){let Z=e.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let Q=D.shadow,ee=t.get(D);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,ee.shadowCameraNear=Q.camera.near,ee.shadowCameraFar=Q.camera.far,n.pointShadow[g]=ee,n.pointShadowMap[g]=le,n.pointShadowMatrix[g]=D.shadow.matrix,E++}n.point[g]=Z,g++}else if(D.isHemisphereLight){let Z=e.get(D);Z.skyColor.copy(D.color).multiplyScalar(q),Z.groundColor.copy(D.groundColor).multiplyScalar(q),n.hemi[b]=Z,b++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Oe.LTC_FLOAT_1,n.rectAreaLTC2=Oe.LTC_FLOAT_2):(n.rectAreaLTC1=Oe.LTC_HALF_1,n.rectAreaLTC2=Oe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let I=n.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==y||I.rectAreaLength!==A||I.hemiLength!==b||I.numSunShadows!==p||I.numDirectionalShadows!==C||I.numPointShadows!==E||I.numSpotShadows!==x||I.numSpotMaps!==w||I.numLightProbes!==L)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=A,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+w-O,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=L,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=y,I.rectAreaLength=A,I.hemiLength=b,I.numSunShadows=p,I.numDirectionalShadows=C,I.numPointShadows=E,I.numSpotShadows=x,I.numSpotMaps=w,I.numLightProbes=L,n.version=qw++)}function l(c,h){let u=0,d=0,f=0,p=0,v=0,m=0,g=h.matrixWorldInverse;for(let y=0,A=c.length;y<A;y++){let b=c[y];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),a.identity(),r.copy(b.matrixWorld),r.premultiply(g),a.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:n}}function s0(i){let e=new $w(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):t.push(u)}function o(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Zw(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new s0(i),e.set(s,[o])):r>=a.length?(o=new s0(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var Jw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Kw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Qw=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],jw=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],r0=new Ct,Bo=new W,Xd=new W;function e1(i,e,t){let n=new Gs,s=new Ee,r=new Ee,a=new Jt,o=new Sc,l=new wc,c={},h=t.maxTextureSize,u={[Zs]:Xn,[Xn]:Zs,[Ln]:Ln},d=new Wn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ee},radius:{value:4}},vertexShader:Jw,fragmentShader:Kw}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Sn;p.setAttribute("position",new Ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ut(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ro;let g=this.type;this.render=function(E,x,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Zm&&(nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ro);let O=i.getRenderTarget(),L=i.getActiveCubeFace(),I=i.getActiveMipmapLevel(),k=i.state;k.setBlending(gr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let H=g!==this.type;H&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=E.length;D<V;D++){let q=E[D],z=q.shadow;if(z===void 0){nt("WebGLShadowMap:",q,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let le=z.getFrameExtents();s.multiply(le),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,z.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Z,z.map===null||H===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===_a){if(q.isPointLight){nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new ai(s.x,s.y,{format:Js,type:Ni,minFilter:Vn,magFilter:Vn,generateMipmaps:!1}),z.map.texture.name=q.name+".shadowMap",z.map.depthTexture=new xs(s.x,s.y,xi),z.map.depthTexture.name=q.name+".shadowMapDepth",z.map.depthTexture.format=ps,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mn,z.map.depthTexture.magFilter=Mn}else q.isPointLight?(z.map=new zo(s.x),z.map.depthTexture=new uo(s.x,Di)):(z.map=new ai(s.x,s.y),z.map.depthTexture=new xs(s.x,s.y,Di)),z.map.depthTexture.name=q.name+".shadowMap",z.map.depthTexture.format=ps,this.type===Ro?(z.map.depthTexture.compareFunction=Z?Dd:Ld,z.map.depthTexture.minFilter=Vn,z.map.depthTexture.magFilter=Vn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mn,z.map.depthTexture.magFilter=Mn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();q.isPointLight!==!0&&z.updateMatrices(q,w);let ee=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:w.layers;for(let de=0;de<Q;de++){let ce=z.getCamera(de);if(q.isPointLight){let j=z.camera,ge=z.matrix,_e=q.distance||j.far;_e!==j.far&&(j.far=_e,j.updateProjectionMatrix()),Bo.setFromMatrixPosition(q.matrixWorld),j.position.copy(Bo),Xd.copy(j.position),Xd.add(Qw[de]),j.up.copy(jw[de]),j.lookAt(Xd),j.updateMatrixWorld(),ge.makeTranslation(-Bo.x,-Bo.y,-Bo.z),r0.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),z._frustum.setFromProjectionMatrix(r0,j.coordinateSystem,j.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,de),i.clear();else{de===0&&(i.setRenderTarget(z.map),i.clear());let j=z.getViewport(de);a.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),k.viewport(a)}n=z.getFrustum(de),b(x,w,ce,q,ee,this.type)}z.isPointLightShadow!==!0&&this.type===_a&&y(z,w),z.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(O,L,I)};function y(E,x){let w=e.update(v);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ai(s.x,s.y,{format:Js,type:Ni}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,w,d,v,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,w,f,v,null)}function A(E,x,w,O){let L=null,I=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(I!==void 0)L=I;else if(L=w.isPointLight===!0?l:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=L.uuid,H=x.uuid,D=c[k];D===void 0&&(D={},c[k]=D);let V=D[H];V===void 0&&(V=L.clone(),D[H]=V,x.addEventListener("dispose",C)),L=V}if(L.visible=x.visible,L.wireframe=x.wireframe,O===_a?L.side=x.shadowSide!==null?x.shadowSide:x.side:L.side=x.shadowSide!==null?x.shadowSide:u[x.side],L.alphaMap=x.alphaMap,L.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,L.map=x.map,L.clipShadows=x.clipShadows,L.clippingPlanes=x.clippingPlanes,L.clipIntersection=x.clipIntersection,L.displacementMap=x.displacementMap,L.displacementScale=x.displacementScale,L.displacementBias=x.displacementBias,L.wireframeLinewidth=x.wireframeLinewidth,L.linewidth=x.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=i.properties.get(L);k.light=w}return L}function b(E,x,w,O,L,I){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&I===_a)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let D=e.update(E),V=E.material;if(Array.isArray(V)){let q=D.groups;for(let z=0,le=q.length;z<le;z++){let Z=q[z],Q=V[Z.materialIndex];if(Q&&Q.visible){let ee=A(E,Q,O,I);E.onBeforeShadow(i,E,x,w,D,ee,Z),i.renderBufferDirect(w,null,D,ee,E,Z),E.onAfterShadow(i,E,x,w,D,ee,Z)}}}else if(V.visible){let q=A(E,V,O,I);E.onBeforeShadow(i,E,x,w,D,q,null),i.renderBufferDirect(w,null,D,q,E,null),E.onAfterShadow(i,E,x,w,D,q,null)}}let H=E.children;for(let D=0,V=H.length;D<V;D++)b(H[D],x,w,O,L,I)}function C(E){E.target.removeEventListener("dispose",C);for(let w in c){let O=c[w],L=E.target.uuid;L in O&&(O[L].dispose(),delete O[L])}}}function t1(i,e){function t(){let U=!1,se=new Jt,ne=null,Re=new Jt(0,0,0,0);return{setMask:function(ye){ne!==ye&&!U&&(i.colorMask(ye,ye,ye,ye),ne=ye)},setLocked:function(ye){U=ye},setClear:function(ye,Ce,Ke,at,he){he===!0&&(ye*=at,Ce*=at,Ke*=at),se.set(ye,Ce,Ke,at),Re.equals(se)===!1&&(i.clearColor(ye,Ce,Ke,at),Re.copy(se))},reset:function(){U=!1,ne=null,Re.set(-1,0,0,0)}}}function n(){let U=!1,se=!1,ne=null,Re=null,ye=null;return{setReversed:function(Ce){if(se!==Ce){let Ke=e.get("EXT_clip_control");Ce?Ke.clipControlEXT(Ke.LOWER_LEFT_EXT,Ke.ZERO_TO_ONE_EXT):Ke.clipControlEXT(Ke.LOWER_LEFT_EXT,Ke.NEGATIVE_ONE_TO_ONE_EXT),se=Ce;let at=ye;ye=null,this.setClear(at)}},getReversed:function(){return se},setTest:function(Ce){Ce?Se(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Ce){ne!==Ce&&!U&&(i.depthMask(Ce),ne=Ce)},setFunc:function(Ce){if(se&&(Ce=Rg[Ce]),Re!==Ce){switch(Ce){case tc:i.depthFunc(i.NEVER);break;case nc:i.depthFunc(i.ALWAYS);break;case ic:i.depthFunc(i.LESS);break;case oa:i.depthFunc(i.LEQUAL);break;case sc:i.depthFunc(i.EQUAL);break;case rc:i.depthFunc(i.GEQUAL);break;case ac:i.depthFunc(i.GREATER);break;case oc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ce}},setLocked:function(Ce){U=Ce},setClear:function(Ce){ye!==Ce&&(ye=Ce,se&&(Ce=1-Ce),i.clearDepth(Ce))},reset:function(){U=!1,ne=null,Re=null,ye=null,se=!1}}}function s(){let U=!1,se=null,ne=null,Re=null,ye=null,Ce=null,Ke=null,at=null,he=null;return{setTest:function(qe){U||(qe?Se(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(qe){se!==qe&&!U&&(i.stencilMask(qe),se=qe)},setFunc:function(qe,ot,Ne){(ne!==qe||Re!==ot||ye!==Ne)&&(i.stencilFunc(qe,ot,Ne),ne=qe,Re=ot,ye=Ne)},setOp:function(qe,ot,Ne){(Ce!==qe||Ke!==ot||at!==Ne)&&(i.stencilOp(qe,ot,Ne),Ce=qe,Ke=ot,at=Ne)},setLocked:function(qe){U=qe},setClear:function(qe){he!==qe&&(i.clearStencil(qe),he=qe)},reset:function(){U=!1,se=null,ne=null,Re=null,ye=null,Ce=null,Ke=null,at=null,he=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],v=null,m=!1,g=null,y=null,A=null,b=null,C=null,E=null,x=null,w=new mt(0,0,0),O=0,L=!1,I=null,k=null,H=null,D=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,le=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),z=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),z=le>=2);let Q=null,ee={},de=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),j=new Jt().fromArray(de),ge=new Jt().fromArray(ce);function _e(U,se,ne,Re){let ye=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(U,Ce),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ke=0;Ke<ne;Ke++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(se+Ke,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return Ce}let Le={};Le[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),Le[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Le[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Le[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),Se(i.DEPTH_TEST),a.setFunc(oa),Be(!1),De(fd),Se(i.CULL_FACE),ve(gr);function Se(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function Ge(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function it(U,se){return d[U]!==se?(i.bindFramebuffer(U,se),d[U]=se,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=se),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=se),!0):!1}function Je(U,se){let ne=p,Re=!1;if(U){ne=f.get(se),ne===void 0&&(ne=[],f.set(se,ne));let ye=U.textures;if(ne.length!==ye.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Ke=ye.length;Ce<Ke;Ce++)ne[Ce]=i.COLOR_ATTACHMENT0+Ce;ne.length=ye.length,Re=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Re=!0);Re&&i.drawBuffers(ne)}function st(U){return v!==U?(i.useProgram(U),v=U,!0):!1}let tt={[xr]:i.FUNC_ADD,[Km]:i.FUNC_SUBTRACT,[Qm]:i.FUNC_REVERSE_SUBTRACT};tt[jm]=i.MIN,tt[eg]=i.MAX;let re={[tg]:i.ZERO,[ng]:i.ONE,[ig]:i.SRC_COLOR,[xd]:i.SRC_ALPHA,[cg]:i.SRC_ALPHA_SATURATE,[og]:i.DST_COLOR,[rg]:i.DST_ALPHA,[sg]:i.ONE_MINUS_SRC_COLOR,[_d]:i.ONE_MINUS_SRC_ALPHA,[lg]:i.ONE_MINUS_DST_COLOR,[ag]:i.ONE_MINUS_DST_ALPHA,[hg]:i.CONSTANT_COLOR,[ug]:i.ONE_MINUS_CONSTANT_COLOR,[dg]:i.CONSTANT_ALPHA,[fg]:i.ONE_MINUS_CONSTANT_ALPHA};function ve(U,se,ne,Re,ye,Ce,Ke,at,he,qe){if(U===gr){m===!0&&(Ge(i.BLEND),m=!1);return}if(m===!1&&(Se(i.BLEND),m=!0),U!==Jm){if(U!==g||qe!==L){if((y!==xr||C!==xr)&&(i.blendEquation(i.FUNC_ADD),y=xr,C=xr),qe)switch(U){case va:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pd:i.blendFunc(i.ONE,i.ONE);break;case md:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case gd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:lt("WebGLState: Invalid blending: ",U);break}else switch(U){case va:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case md:lt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case gd:lt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:lt("WebGLState: Invalid blending: ",U);break}A=null,b=null,E=null,x=null,w.set(0,0,0),O=0,g=U,L=qe}return}ye=ye||se,Ce=Ce||ne,Ke=Ke||Re,(se!==y||ye!==C)&&(i.blendEquationSeparate(tt[se],tt[ye]),y=se,C=ye),(ne!==A||Re!==b||Ce!==E||Ke!==x)&&(i.blendFuncSeparate(re[ne],re[Re],re[Ce],re[Ke]),A=ne,b=Re,E=Ce,x=Ke),(at.equals(w)===!1||he!==O)&&(i.blendColor(at.r,at.g,at.b,he),w.copy(at),O=he),g=U,L=!1}function xe(U,se){U.side===Ln?Ge(i.CULL_FACE):Se(i.CULL_FACE);let ne=U.side===Xn;se&&(ne=!ne),Be(ne),U.blending===va&&U.transparent===!1?ve(gr):ve(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),a.setFunc(U.depthFunc),a.setTest(U.depthTest),a.setMask(U.depthWrite),r.setMask(U.colorWrite);let Re=U.stencilWrite;o.setTest(Re),Re&&(o.setMask(U.stencilWriteMask),o.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),o.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),ke(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?Se(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function Be(U){I!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),I=U)}function De(U){U!==Ym?(Se(i.CULL_FACE),U!==k&&(U===fd?i.cullFace(i.BACK):U===$m?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),k=U}function et(U){U!==H&&(z&&i.lineWidth(U),H=U)}function ke(U,se,ne){U?(Se(i.POLYGON_OFFSET_FILL),(D!==se||V!==ne)&&(D=se,V=ne,a.getReversed()&&(se=-se,ne=-ne),i.polygonOffset(se,ne))):Ge(i.POLYGON_OFFSET_FILL)}function pt(U){U?Se(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function ut(U){U===void 0&&(U=i.TEXTURE0+q-1),Q!==U&&(i.activeTexture(U),Q=U)}function xt(U,se,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+q-1:ne=Q);let Re=ee[ne];Re===void 0&&(Re={type:void 0,texture:void 0},ee[ne]=Re),(Re.type!==U||Re.texture!==se)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(U,se||Le[U]),Re.type=U,Re.texture=se)}function F(){let U=ee[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function be(){try{i.compressedTexImage2D(...arguments)}catch(U){lt("WebGLState:",U)}}function Xe(){try{i.compressedTexImage3D(...arguments)}catch(U){lt("WebGLState:",U)}}function ct(){try{i.texSubImage2D(...arguments)}catch(U){lt("WebGLState:",U)}}function we(){try{i.texSubImage3D(...arguments)}catch(U){lt("WebGLState:",U)}}function Dt(){try{i.compressedTexSubImage2D(...arguments)}catch(U){lt("WebGLState:",U)}}function $e(){try{i.compressedTexSubImage3D(...arguments)}catch(U){lt("WebGLState:",U)}}function je(){try{i.texStorage2D(...arguments)}catch(U){lt("WebGLState:",U)}}function R(){try{i.texStorage3D(...arguments)}catch(U){lt("WebGLState:",U)}}function M(){try{i.texImage2D(...arguments)}catch(U){lt("WebGLState:",U)}}function X(){try{i.texImage3D(...arguments)}catch(U){lt("WebGLState:",U)}}function ue(U){return u[U]!==void 0?u[U]:i.getParameter(U)}function ae(U,se){u[U]!==se&&(i.pixelStorei(U,se),u[U]=se)}function Me(U){j.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),j.copy(U))}function Te(U){ge.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),ge.copy(U))}function te(U,se){let ne=c.get(se);ne===void 0&&(ne=new WeakMap,c.set(se,ne));let Re=ne.get(U);Re===void 0&&(Re=i.getUniformBlockIndex(se,U.name),i.uniformBlockBinding(se,Re,Re),ne.set(U,Re))}function ie(U,se,ne){let ye=c.get(se).get(U);l[ye]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,ne),l[ye]=ne)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ee={},d={},l={},f=new WeakMap,p=[],v=null,m=!1,g=null,y=null,A=null,b=null,C=null,E=null,x=null,w=new mt(0,0,0),O=0,L=!1,I=null,k=null,H=null,D=null,V=null,j.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:Se,disable:Ge,bindFramebuffer:it,drawBuffers:Je,useProgram:st,setBlending:ve,setMaterial:xe,setFlipSided:Be,setCullFace:De,setLineWidth:et,setPolygonOffset:ke,setScissorTest:pt,activeTexture:ut,bindTexture:xt,unbindTexture:F,compressedTexImage2D:be,compressedTexImage3D:Xe,texImage2D:M,texImage3D:X,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:je,texStorage3D:R,texSubImage2D:ct,texSubImage3D:we,compressedTexSubImage2D:Dt,compressedTexSubImage3D:$e,scissor:Me,viewport:Te,reset:me}}function n1(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ee,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,v=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,M){return m?new OffscreenCanvas(R,M):io("canvas")}function y(R,M,X){let ue=1,ae=je(R);if((ae.width>X||ae.height>X)&&(ue=X/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let Me=Math.floor(ue*ae.width),Te=Math.floor(ue*ae.height);d===void 0&&(d=g(Me,Te));let te=M?g(Me,Te):d;return te.width=Me,te.height=Te,te.getContext("2d").drawImage(R,0,0,Me,Te),nt("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+Me+"x"+Te+")."),te}else return"data"in R&&nt("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function A(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(R,M,X,ue,ae,Me=!1){if(R!==null){if(i[R]!==void 0)return i[R];nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Te;ue&&(Te=e.get("EXT_texture_norm16"),Te||nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&Te&&(te=Te.R16_EXT),X===i.SHORT&&Te&&(te=Te.R16_SNORM_EXT)),M===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),M===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&Te&&(te=Te.RG16_EXT),X===i.SHORT&&Te&&(te=Te.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),M===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),M===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),M===i.RGB&&(X===i.UNSIGNED_SHORT&&Te&&(te=Te.RGB16_EXT),X===i.SHORT&&Te&&(te=Te.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),M===i.RGBA){let ie=Me?no:At.getTransfer(ae);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=ie===Ft?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&Te&&(te=Te.RGBA16_EXT),X===i.SHORT&&Te&&(te=Te.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,M){let X;return R?M===null||M===Di||M===vr?X=i.DEPTH24_STENCIL8:M===xi?X=i.DEPTH32F_STENCIL8:M===ba&&(X=i.DEPTH24_STENCIL8,nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Di||M===vr?X=i.DEPTH_COMPONENT24:M===xi?X=i.DEPTH_COMPONENT32F:M===ba&&(X=i.DEPTH_COMPONENT16),X}function w(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Mn&&R.minFilter!==Vn?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function O(R){let M=new WeakRef(R);n.get(R).__ref=M,p.add(M),v.register(R,M,M)}function L(R){let M=n.get(R).__ref;M!==void 0&&(p.delete(M),v.unregister(M))}function I(R){H(R.target)}function k(R){D(R.target)}function H(R){R.removeEventListener("dispose",I),L(R),q(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function D(R){R.removeEventListener("dispose",k),L(R),le(R)}function V(){for(let R of p){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?D(M):H(M))}p.clear(),u.clear()}function q(R){let M=n.get(R);if(M.__webglInit===void 0)return;let X=R.source,ue=f.get(X);if(ue){let ae=ue[M.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&z(R),Object.keys(ue).length===0&&f.delete(X)}n.remove(R)}function z(R){let M=n.get(R);i.deleteTexture(M.__webglTexture);let X=R.source,ue=f.get(X);delete ue[M.__cacheKey],a.memory.textures--}function le(R){let M=n.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&H(X),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(M.__webglFramebuffer[ae]))for(let Me=0;Me<M.__webglFramebuffer[ae].length;Me++)i.deleteFramebuffer(M.__webglFramebuffer[ae][Me]);else i.deleteFramebuffer(M.__webglFramebuffer[ae]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[ae])}else{if(Array.isArray(M.__webglFramebuffer))for(let ae=0;ae<M.__webglFramebuffer.length;ae++)i.deleteFramebuffer(M.__webglFramebuffer[ae]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ae=0;ae<M.__webglColorRenderbuffer.length;ae++)M.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[ae]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let ae=0,Me=ue.length;ae<Me;ae++){let Te=n.get(ue[ae]);Te.__webglTexture&&(i.deleteTexture(Te.__webglTexture),a.memory.textures--),n.remove(ue[ae])}n.remove(R)}let Z=0;function Q(){Z=0}function ee(){return Z}function de(R){Z=R}function ce(){let R=Z;return R>=s.maxTextures&&nt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function j(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function ge(R,M){let X=n.get(R);if(R.isVideoTexture&&Dt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ue=R.image;if(ue===null)nt("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)nt("WebGLRenderer: Texture marked for update but image is incomplete");else{xe(X,R,M);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+M)}function _e(R,M){let X=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){xe(X,R,M);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+M)}function Le(R,M){let X=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){xe(X,R,M);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+M)}function Se(R,M){let X=n.get(R);if(R.version>0&&X.__version!==R.version){Be(X,R,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+M)}let Ge={[fr]:i.REPEAT,[qi]:i.CLAMP_TO_EDGE,[lc]:i.MIRRORED_REPEAT},it={[Mn]:i.NEAREST,[gg]:i.NEAREST_MIPMAP_NEAREST,[Io]:i.NEAREST_MIPMAP_LINEAR,[Vn]:i.LINEAR,[zc]:i.LINEAR_MIPMAP_NEAREST,[vs]:i.LINEAR_MIPMAP_LINEAR},Je={[yg]:i.NEVER,[Nd]:i.ALWAYS,[bg]:i.LESS,[Ld]:i.LEQUAL,[Mg]:i.EQUAL,[Dd]:i.GEQUAL,[Sg]:i.GREATER,[wg]:i.NOTEQUAL};function st(R,M){if(M.type===xi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Vn||M.magFilter===zc||M.magFilter===Io||M.magFilter===vs||M.minFilter===Vn||M.minFilter===zc||M.minFilter===Io||M.minFilter===vs)&&nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Ge[M.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Ge[M.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Ge[M.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,it[M.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,it[M.minFilter]),M.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Je[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Mn||M.minFilter!==Io&&M.minFilter!==vs||M.type===xi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function tt(R,M){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",I),O(M));let ue=M.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let Me=j(M);if(Me!==R.__cacheKey){ae[Me]===void 0&&(ae[Me]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,X=!0),ae[Me].usedTimes++;let Te=ae[R.__cacheKey];Te!==void 0&&(ae[R.__cacheKey].usedTimes--,Te.usedTimes===0&&z(M)),R.__cacheKey=Me,R.__webglTexture=ae[Me].texture}return X}function re(R,M,X){return Math.floor(Math.floor(R/X)/M)}function ve(R,M,X,ue){let Me=R.updateRanges;if(Me.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,X,ue,M.data);else{Me.sort((U,se)=>U.start-se.start);let Te=0;for(let U=1;U<Me.length;U++){let se=Me[Te],ne=Me[U],Re=se.start+se.count,ye=re(ne.start,M.width,4),Ce=re(se.start,M.width,4);ne.start<=Re+1&&ye===Ce&&re(ne.start+ne.count-1,M.width,4)===ye?se.count=Math.max(se.count,ne.start+ne.count-se.start):(++Te,Me[Te]=ne)}Me.length=Te+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),ie=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let U=0,se=Me.length;U<se;U++){let ne=Me[U],Re=Math.floor(ne.start/4),ye=Math.ceil(ne.count/4),Ce=Re%M.width,Ke=Math.floor(Re/M.width),at=ye,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ce),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ke),t.texSubImage2D(i.TEXTURE_2D,0,Ce,Ke,at,he,X,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function xe(R,M,X){let ue=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=i.TEXTURE_3D);let ae=tt(R,M),Me=M.source;t.bindTexture(ue,R.__webglTexture,i.TEXTURE0+X);let Te=n.get(Me);if(Me.version!==Te.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let he=At.getPrimaries(At.workingColorSpace),qe=M.colorSpace===bs?null:At.getPrimaries(M.colorSpace),ot=M.colorSpace===bs||he===qe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ot)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=y(M.image,!1,s.maxTextureSize);ie=$e(M,ie);let me=r.convert(M.format,M.colorSpace),U=r.convert(M.type),se=E(M.internalFormat,me,U,M.normalized,M.colorSpace,M.isVideoTexture);st(ue,M);let ne,Re=M.mipmaps,ye=M.isVideoTexture!==!0,Ce=Te.__version===void 0||ae===!0,Ke=Me.dataReady,at=w(M,ie);if(M.isDepthTexture)se=x(M.format===ys,M.type),Ce&&(ye?t.texStorage2D(i.TEXTURE_2D,1,se,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,se,ie.width,ie.height,0,me,U,null));else if(M.isDataTexture)if(Re.length>0){ye&&Ce&&t.texStorage2D(i.TEXTURE_2D,at,se,Re[0].width,Re[0].height);for(let he=0,qe=Re.length;he<qe;he++)ne=Re[he],ye?Ke&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,U,ne.data):t.texImage2D(i.TEXTURE_2D,he,se,ne.width,ne.height,0,me,U,ne.data);M.generateMipmaps=!1}else ye?(Ce&&t.texStorage2D(i.TEXTURE_2D,at,se,ie.width,ie.height),Ke&&ve(M,ie,me,U)):t.texImage2D(i.TEXTURE_2D,0,se,ie.width,ie.height,0,me,U,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ye&&Ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,at,se,Re[0].width,Re[0].height,ie.depth);for(let he=0,qe=Re.length;he<qe;he++)if(ne=Re[he],M.format!==Fi)if(me!==null)if(ye){if(Ke)if(M.layerUpdates.size>0){let ot=Hd(ne.width,ne.height,M.format,M.type);for(let Ne of M.layerUpdates){let gt=ne.data.subarray(Ne*ot/ne.data.BYTES_PER_ELEMENT,(Ne+1)*ot/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Ne,ne.width,ne.height,1,me,gt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,se,ne.width,ne.height,ie.depth,0,ne.data,0,0);else nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Ke&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,me,U,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,se,ne.width,ne.height,ie.depth,0,me,U,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ye&&Ce&&t.texStorage2D(i.TEXTURE_2D,at,se,Re[0].width,Re[0].height);for(let he=0,qe=Re.length;he<qe;he++)ne=Re[he],M.format!==Fi?me!==null?ye?Ke&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,se,ne.width,ne.height,0,ne.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Ke&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,U,ne.data):t.texImage2D(i.TEXTURE_2D,he,se,ne.width,ne.height,0,me,U,ne.data)}else if(M.isDataArrayTexture)if(ye){if(Ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,at,se,ie.width,ie.height,ie.depth),Ke)if(M.layerUpdates.size>0){let he=Hd(ie.width,ie.height,M.format,M.type);for(let qe of M.layerUpdates){let ot=ie.data.subarray(qe*he/ie.data.BYTES_PER_ELEMENT,(qe+1)*he/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,qe,ie.width,ie.height,1,me,U,ot)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,U,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,me,U,ie.data);else if(M.isData3DTexture)ye?(Ce&&t.texStorage3D(i.TEXTURE_3D,at,se,ie.width,ie.height,ie.depth),Ke&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,U,ie.data)):t.texImage3D(i.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,me,U,ie.data);else if(M.isFramebufferTexture){if(Ce)if(ye)t.texStorage2D(i.TEXTURE_2D,at,se,ie.width,ie.height);else{let he=ie.width,qe=ie.height;for(let ot=0;ot<at;ot++)t.texImage2D(i.TEXTURE_2D,ot,se,he,qe,0,me,U,null),he>>=1,qe>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),ie.parentNode!==he){he.appendChild(ie),u.add(M),he.onpaint=qe=>{let ot=qe.changedElements;for(let Ne of u)ot.includes(Ne.image)&&(Ne.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ie);else{let ot=i.RGBA,Ne=i.RGBA,gt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ot,Ne,gt,ie)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(ye&&Ce){let he=je(Re[0]);t.texStorage2D(i.TEXTURE_2D,at,se,he.width,he.height)}for(let he=0,qe=Re.length;he<qe;he++)ne=Re[he],ye?Ke&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,U,ne):t.texImage2D(i.TEXTURE_2D,he,se,me,U,ne);M.generateMipmaps=!1}else if(ye){if(Ce){let he=je(ie);t.texStorage2D(i.TEXTURE_2D,at,se,he.width,he.height)}Ke&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,U,ie)}else t.texImage2D(i.TEXTURE_2D,0,se,me,U,ie);A(M)&&M.mipmapsAutoUpdate===!0&&b(ue),Te.__version=Me.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Be(R,M,X){if(M.image.length!==6)return;let ue=tt(R,M),ae=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+X);let Me=n.get(ae);if(ae.version!==Me.__version||ue===!0){t.activeTexture(i.TEXTURE0+X);let Te=At.getPrimaries(At.workingColorSpace),te=M.colorSpace===bs?null:At.getPrimaries(M.colorSpace),ie=M.colorSpace===bs||Te===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=M.isCompressedTexture||M.image[0].isCompressedTexture,U=M.image[0]&&M.image[0].isDataTexture,se=[];for(let Ne=0;Ne<6;Ne++)!me&&!U?se[Ne]=y(M.image[Ne],!0,s.maxCubemapSize):se[Ne]=U?M.image[Ne].image:M.image[Ne],se[Ne]=$e(M,se[Ne]);let ne=se[0],Re=r.convert(M.format,M.colorSpace),ye=r.convert(M.type),Ce=E(M.internalFormat,Re,ye,M.normalized,M.colorSpace),Ke=M.isVideoTexture!==!0,at=Me.__version===void 0||ue===!0,he=ae.dataReady,qe=w(M,ne);st(i.TEXTURE_CUBE_MAP,M);let ot;if(M.isDepthTexture){if(Ce=x(M.format===ys,M.type),at)if(Ke)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ce,ne.width,ne.height);else for(let Ne=0;Ne<6;Ne++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,ne.width,ne.height,0,Re,ye,null)}else if(me){Ke&&at&&t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ce,ne.width,ne.height);for(let Ne=0;Ne<6;Ne++){ot=se[Ne].mipmaps;for(let gt=0;gt<ot.length;gt++){let Ht=ot[gt];M.format!==Fi?Re!==null?Ke?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt,0,0,Ht.width,Ht.height,Re,Ht.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt,Ce,Ht.width,Ht.height,0,Ht.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ke?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt,0,0,Ht.width,Ht.height,Re,ye,Ht.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt,Ce,Ht.width,Ht.height,0,Re,ye,Ht.data)}}}else{if(ot=M.mipmaps,Ke&&at){ot.length>0&&qe++;let Ne=je(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,qe,Ce,Ne.width,Ne.height)}for(let Ne=0;Ne<6;Ne++)if(U){Ke?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,0,0,se[Ne].width,se[Ne].height,Re,ye,se[Ne].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,se[Ne].width,se[Ne].height,0,Re,ye,se[Ne].data);for(let gt=0;gt<ot.length;gt++){let Nn=ot[gt].image[Ne].image;Ke?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt+1,0,0,Nn.width,Nn.height,Re,ye,Nn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt+1,Ce,Nn.width,Nn.height,0,Re,ye,Nn.data)}}else{Ke?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,0,0,Re,ye,se[Ne]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,Re,ye,se[Ne]);for(let gt=0;gt<ot.length;gt++){let Ht=ot[gt];Ke?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt+1,0,0,Re,ye,Ht.image[Ne]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,gt+1,Ce,Re,ye,Ht.image[Ne])}}}A(M)&&M.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),Me.__version=ae.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function De(R,M,X,ue,ae,Me){let Te=r.convert(X.format,X.colorSpace),te=r.convert(X.type),ie=E(X.internalFormat,Te,te,X.normalized,X.colorSpace),me=n.get(M),U=n.get(X);if(U.__renderTarget=M,!me.__hasExternalTextures){let se=Math.max(1,M.width>>Me),ne=Math.max(1,M.height>>Me);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,Me,ie,se,ne,M.depth,0,Te,te,null):t.texImage2D(ae,Me,ie,se,ne,0,Te,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),we(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,ae,U.__webglTexture,0,ct(M)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,ae,U.__webglTexture,Me),t.bindFramebuffer(i.FRAMEBUFFER,null)}function et(R,M,X){if(i.bindRenderbuffer(i.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,Me=x(M.stencilBuffer,ae),Te=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(M),Me,M.width,M.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(M),Me,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,Me,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Te,i.RENDERBUFFER,R)}else{let ue=M.textures;for(let ae=0;ae<ue.length;ae++){let Me=ue[ae],Te=r.convert(Me.format,Me.colorSpace),te=r.convert(Me.type),ie=E(Me.internalFormat,Te,te,Me.normalized,Me.colorSpace);we(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(M),ie,M.width,M.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(M),ie,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,ie,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ke(R,M,X){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(M.depthTexture);ae.__renderTarget=M;let Me=ue?M.depthTexture.image[0]:M.depthTexture.image;(!ae.__webglTexture||Me.width!==M.width||Me.height!==M.height)&&(Me.width=M.width,Me.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):ge(M.depthTexture,0);let Te=ae.__webglTexture,te=ct(M),ie=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,me=M.depthTexture.format===ys?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===ps)we(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,Te,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,Te,0);else if(M.depthTexture.format===ys)we(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,Te,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,Te,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pt(R){let M=n.get(R),X=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let ae=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),M.__depthDisposeCallback=ae}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)ke(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?ke(M.__webglFramebuffer[0],R,0):ke(M.__webglFramebuffer,R,0);else if(X){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=i.createRenderbuffer(),et(M.__webglDepthbuffer[ue],R,!1);else{let ae=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=M.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,Me),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,Me)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),et(M.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Me),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,Me)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ut(R,M,X){let ue=n.get(R);M!==void 0&&De(ue.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&pt(R)}function xt(R){let M=R.texture,X=n.get(R),ue=n.get(M);R.addEventListener("dispose",k),O(R);let ae=R.textures,Me=R.isWebGLCubeRenderTarget===!0,Te=ae.length>1;if(Te||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=M.version,a.memory.textures++),Me){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)X.__webglFramebuffer[te][ie]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(Te)for(let te=0,ie=ae.length;te<ie;te++){let me=n.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),a.memory.textures++)}if(R.samples>0&&we(R)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let ie=ae[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let me=r.convert(ie.format,ie.colorSpace),U=r.convert(ie.type),se=E(ie.internalFormat,me,U,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=ct(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,se,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),et(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Me){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),st(i.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)De(X.__webglFramebuffer[te][ie],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else De(X.__webglFramebuffer[te],R,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?b(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(Te){for(let te=0,ie=ae.length;te<ie;te++){let me=ae[te],U=n.get(me),se=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,U.__webglTexture),st(se,me),De(X.__webglFramebuffer,R,me,i.COLOR_ATTACHMENT0+te,se,0),A(me)&&b(se)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),st(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)De(X.__webglFramebuffer[ie],R,M,i.COLOR_ATTACHMENT0,te,ie);else De(X.__webglFramebuffer,R,M,i.COLOR_ATTACHMENT0,te,0);A(M)?b(te):M.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&pt(R)}function F(R){let M=R.textures;for(let X=0,ue=M.length;X<ue;X++){let ae=M[X];if(A(ae)&&ae.mipmapsAutoUpdate===!0){let Me=C(R),Te=n.get(ae).__webglTexture;t.bindTexture(Me,Te),b(Me),t.unbindTexture()}}}let be=[];function Xe(R){if(R.samples>0){if(we(R)===!1){let M=R.textures,X=R.width,ue=R.height,ae=i.COLOR_BUFFER_BIT,Me=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Te=n.get(R),te=M.length>1;if(te)for(let me=0;me<M.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Te.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Te.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Te.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Te.__webglFramebuffer);for(let me=0;me<M.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Te.__webglColorRenderbuffer[me]);let U=n.get(M[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,X,ue,0,0,X,ue,ae,i.NEAREST),l===!0&&(be.length=0,be.push(i.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&be.push(Me),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,be))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<M.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,Te.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,Te.__webglColorRenderbuffer[me]);let U=n.get(M[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Te.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Te.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ct(R){return Math.min(s.maxSamples,R.samples)}function we(R){let M=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Dt(R){let M=a.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}function $e(R,M){let X=R.colorSpace,ue=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==to&&X!==bs&&(At.getTransfer(X)===Ft?(ue!==Fi||ae!==Yn)&&nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):lt("WebGLTextures: Unsupported texture color space:",X)),M}function je(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=Q,this.getTextureUnits=ee,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=_e,this.setTexture3D=Le,this.setTextureCube=Se,this.rebindTextures=ut,this.setupRenderTarget=xt,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Xe,this.setupDepthRenderbuffer=pt,this.setupFrameBufferTexture=De,this.useMultisampledRTT=we,this.dispose=V}function i1(i,e){function t(n,s=bs){let r,a=At.getTransfer(s);if(n===Yn)return i.UNSIGNED_BYTE;if(n===Gc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Hc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Cd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Rd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Ad)return i.BYTE;if(n===Ed)return i.SHORT;if(n===ba)return i.UNSIGNED_SHORT;if(n===Vc)return i.INT;if(n===Di)return i.UNSIGNED_INT;if(n===xi)return i.FLOAT;if(n===Ni)return i.HALF_FLOAT;if(n===Pd)return i.ALPHA;if(n===Id)return i.RGB;if(n===Fi)return i.RGBA;if(n===ps)return i.DEPTH_COMPONENT;if(n===ys)return i.DEPTH_STENCIL;if(n===Wc)return i.RED;if(n===Xc)return i.RED_INTEGER;if(n===Js)return i.RG;if(n===qc)return i.RG_INTEGER;if(n===Yc)return i.RGBA_INTEGER;if(n===Lo||n===Do||n===No||n===Fo)if(a===Ft)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Lo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Do)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===No)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Fo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Lo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Do)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===No)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Fo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===$c||n===Zc||n===Jc||n===Kc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===$c)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Qc||n===jc||n===eh||n===th||n===nh||n===Uo||n===ih)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Qc||n===jc)return a===Ft?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===eh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===th)return r.COMPRESSED_R11_EAC;if(n===nh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Uo)return r.COMPRESSED_RG11_EAC;if(n===ih)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===sh||n===rh||n===ah||n===oh||n===lh||n===ch||n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===sh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===rh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ah)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===oh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===lh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ch)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===hh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===uh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===dh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===fh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ph)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===mh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===gh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xh)return a===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_h||n===vh||n===yh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===_h)return a===Ft?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===yh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===bh||n===Mh||n===Oo||n===Sh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===bh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Mh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Oo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Sh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var s1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,r1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Qd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new fo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Wn({vertexShader:s1,fragmentShader:r1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ut(new Li(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jd=class extends $i{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,v=typeof XRWebGLBinding<"u",m=new Qd,g={},y=t.getContextAttributes(),A=null,b=null,C=[],E=[],x=new Ee,w=null,O=null,L=new zn;L.viewport=new Jt;let I=new zn;I.viewport=new Jt;let k=[L,I],H=new Uc,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let ge=C[j];return ge===void 0&&(ge=new ua,C[j]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(j){let ge=C[j];return ge===void 0&&(ge=new ua,C[j]=ge),ge.getGripSpace()},this.getHand=function(j){let ge=C[j];return ge===void 0&&(ge=new ua,C[j]=ge),ge.getHandSpace()};function q(j){let ge=E.indexOf(j.inputSource);if(ge===-1)return;let _e=C[ge];_e!==void 0&&(_e.update(j.inputSource,j.frame,c||a),_e.dispatchEvent({type:j.type,data:j.inputSource}))}function z(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",le);for(let j=0;j<C.length;j++){let ge=E[j];ge!==null&&(E[j]=null,C[j].disconnect(ge))}D=null,V=null,m.reset();for(let j in g)delete g[j];if(e.setRenderTarget(A),f=null,d=null,u=null,s=null,b=null,ce.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),O!==null){let j=O.camera;j.fov=O.fov,j.zoom=O.zoom,j.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){o=j,n.isPresenting===!0&&nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",z),s.addEventListener("inputsourceschange",le),y.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Le=null,Se=null;y.depth&&(Se=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=y.stencil?ys:ps,Le=y.stencil?vr:Di);let Ge={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ge),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new ai(d.textureWidth,d.textureHeight,{format:Fi,type:Yn,depthTexture:new xs(d.textureWidth,d.textureHeight,Le,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _e={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ai(f.framebufferWidth,f.framebufferHeight,{format:Fi,type:Yn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),ce.setContext(s),ce.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(j){for(let ge=0;ge<j.removed.length;ge++){let _e=j.removed[ge],Le=E.indexOf(_e);Le>=0&&(E[Le]=null,C[Le].disconnect(_e))}for(let ge=0;ge<j.added.length;ge++){let _e=j.added[ge],Le=E.indexOf(_e);if(Le===-1){for(let Ge=0;Ge<C.length;Ge++)if(Ge>=E.length){E.push(_e),Le=Ge;break}else if(E[Ge]===null){E[Ge]=_e,Le=Ge;break}if(Le===-1)break}let Se=C[Le];Se&&Se.connect(_e)}}function Z(j,ge){ge===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(ge.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let ge=j.near,_e=j.far;m.texture!==null&&(m.depthNear>0&&(ge=m.depthNear),m.depthFar>0&&(_e=m.depthFar)),H.near=I.near=L.near=ge,H.far=I.far=L.far=_e,(D!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),D=H.near,V=H.far),H.layers.mask=j.layers.mask|6,L.layers.mask=H.layers.mask&-5,I.layers.mask=H.layers.mask&-3;let Le=j.parent,Se=H.cameras;Z(H,Le);for(let Ge=0;Ge<Se.length;Ge++)Z(Se[Ge],Le);H.projectionMatrix.copy(L.projectionMatrix),H.projectionMatrixInverse.copy(L.projectionMatrixInverse),O===null&&j.isPerspectiveCamera&&(O={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,H,Le)};function Q(j,ge,_e){_e===null?j.matrix.copy(ge.matrixWorld):(j.matrix.copy(_e.matrixWorld),j.matrix.invert(),j.matrix.multiply(ge.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(ge.projectionMatrix),j.projectionMatrixInverse.copy(ge.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=hc*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(j){l=j,d!==null&&(d.fixedFoveation=j),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(j){return g[j]};let ee=null;function de(j,ge){if(h=ge.getViewerPose(c||a),p=ge,h!==null){let _e=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Le=!1;_e.length!==H.cameras.length&&(H.cameras.length=0,Le=!0);for(let Je=0;Je<_e.length;Je++){let st=_e[Je],tt=null;if(f!==null)tt=f.getViewport(st);else{let ve=u.getViewSubImage(d,st);tt=ve.viewport,Je===0&&(e.setRenderTargetTextures(b,ve.colorTexture,ve.depthStencilTexture),e.setRenderTarget(b))}let re=k[Je];re===void 0&&(re=new zn,re.layers.enable(Je),re.viewport=new Jt,k[Je]=re),re.matrix.fromArray(st.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(st.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(tt.x,tt.y,tt.width,tt.height),Je===0&&(H.matrix.copy(re.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Le===!0&&H.cameras.push(re)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let Je=u.getDepthInformation(_e[0]);Je&&Je.isValid&&Je.texture&&m.init(Je,s.renderState)}if(Se&&Se.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let Je=0;Je<_e.length;Je++){let st=_e[Je].camera;if(st){let tt=g[st];tt||(tt=new fo,g[st]=tt);let re=u.getCameraImage(st);tt.sourceTexture=re}}}}for(let _e=0;_e<C.length;_e++){let Le=E[_e],Se=C[_e];Le!==null&&Se!==void 0&&Se.update(Le,ge,c||a)}ee&&ee(j,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let ce=new a0;ce.setAnimationLoop(de),this.setAnimationLoop=function(j){ee=j},this.dispose=function(){}}},a1=new Ct,g0=new dt;g0.set(-1,0,0,0,1,0,0,0,1);function o1(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,zd(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,A,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),v(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,y,A):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Xn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Xn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),A=y.envMap,b=y.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(a1.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(g0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,A){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=A*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Xn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function v(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function l1(i,e,t,n){let s={},r={};function a(y,A){let b=A.program;n.uniformBlockBinding(y,b,s[y.id])}function o(y,A){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",m));let C=A.program;n.updateUBOMapping(y,C);let E=e.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let A=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(y){let A=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=b.length;E<x;E++){let w=b[E];if(Array.isArray(w))for(let O=0,L=w.length;O<L;O++)h(w[O],E,O,C);else h(w,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,A,b,C){if(d(y,A,b,C)===!0){let E=y.__offset,x=y.value;if(Array.isArray(x)){let w=0;for(let O=0;O<x.length;O++){let L=x[O],I=v(L,!0);u(L,y.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function u(y,A,b){typeof y=="number"||typeof y=="boolean"?A[b]=y:y.isMatrix3?(A[b]=y.elements[0],A[b+1]=y.elements[1],A[b+2]=y.elements[2],A[b+3]=0,A[b+4]=y.elements[3],A[b+5]=y.elements[4],A[b+6]=y.elements[5],A[b+7]=0,A[b+8]=y.elements[6],A[b+9]=y.elements[7],A[b+10]=y.elements[8],A[b+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-b),b):y.toArray(A,b)}function d(y,A,b,C){let E=y.value,x=A+"_"+b;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let w=C[x],O=!1;for(let L=0;L<E.length;L++)f(E[L],w,L)===!0&&(O=!0);return O}return f(E,C,x)}function f(y,A,b){if(A[b]===void 0)return typeof y=="number"||typeof y=="boolean"?A[b]=y:ArrayBuffer.isView(y)?A[b]=y.slice():A[b]=y.clone(),!0;{let C=A[b];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return A[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function p(y){let A=y.uniforms,b=0,C=16;for(let x=0,w=A.length;x<w;x++){let O=Array.isArray(A[x])?A[x]:[A[x]];for(let L=0,I=O.length;L<I;L++){let k=O[L],H=Array.isArray(k.value)?k.value:[k.value],D=Array.isArray(A[x])||Array.isArray(k.value),V=b;for(let z=0,le=H.length;z<le;z++){let Z=H[z],Q=v(Z,D),ee=b%C,de=ee%Q.boundary,ce=ee+de;b+=de,ce!==0&&C-ce<Q.storage&&(b+=C-ce),z===0&&(V=b),b+=Q.storage}let q=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new q((b-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}let E=b%C;return E>0&&(b+=C-E),y.__size=b,y.__cache={},this}function v(y,A){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):nt("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(y){let A=y.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:a,update:o,dispose:g}}var c1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ki=null;function h1(){return Ki===null&&(Ki=new co(c1,16,16,Js,Ni),Ki.name="DFG_LUT",Ki.minFilter=Vn,Ki.magFilter=Vn,Ki.wrapS=qi,Ki.wrapT=qi,Ki.generateMipmaps=!1,Ki.needsUpdate=!0),Ki}var Ch=class{constructor(e={}){let{canvas:t=Ag(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Yn}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=a;let v=f,m=new Set([Yc,qc,Xc]),g=new Set([Yn,Di,ba,vr,Gc,Hc]),y=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],w=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,k=null,H=null,D=null,V=null;this._outputColorSpace=En;let q=0,z=0,le=null,Z=-1,Q=null,ee=new Jt,de=new Jt,ce=null,j=new mt(0),ge=0,_e=t.width,Le=t.height,Se=1,Ge=null,it=null,Je=new Jt(0,0,_e,Le),st=new Jt(0,0,_e,Le),tt=!1,re=new Gs,ve=new mc,xe=!1,Be=!1,De=new Ct,et=new W,ke=new Jt,pt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ut=!1;function xt(){return le===null?Se:1}let F=n;function be(T,B){return t.getContext(T,B)}let Xe,ct,we,Dt,$e,je,R,M,X,ue,ae,Me,Te,te,ie,me,U,se,ne,Re,ye,Ce,Ke;try{let T={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",qe,!1),t.addEventListener("webglcontextrestored",ot,!1),t.addEventListener("webglcontextcreationerror",Ne,!1),F===null){let B="webgl2";if(F=be(B,T),F===null)throw be(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}at()}catch(T){throw t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",ot,!1),t.removeEventListener("webglcontextcreationerror",Ne,!1),lt("WebGLRenderer: "+T.message),T}function at(){Xe=new bS(F),Xe.init(),ye=new i1(F,Xe),ct=new hS(F,Xe,e,ye),we=new t1(F,Xe),ct.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),H=F.createFramebuffer(),D=F.createFramebuffer(),V=F.createFramebuffer(),Dt=new wS(F),$e=new Vw,je=new n1(F,Xe,we,$e,ct,ye,Dt),R=new yS(L),M=new Ay(F),Ce=new lS(F,M),X=new MS(F,M,Dt,Ce),ue=new AS(F,X,M,Ce,Dt),se=new TS(F,ct,je),ie=new uS($e),ae=new zw(L,R,Xe,ct,Ce,ie),Me=new o1(L,$e),Te=new Hw,te=new Zw(Xe),U=new oS(L,R,we,ue,p,l),me=new e1(L,ue,ct),Ke=new l1(F,Dt,ct,we),ne=new cS(F,Xe,Dt),Re=new SS(F,Xe,Dt),Dt.programs=ae.programs,L.capabilities=ct,L.extensions=Xe,L.properties=$e,L.renderLists=Te,L.shadowMap=me,L.state=we,L.info=Dt}v!==Yn&&(O=new CS(v,t.width,t.height,o,s,r));let he=new jd(L,F);this.xr=he,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let T=Xe.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Xe.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(T){T!==void 0&&(Se=T,this.setSize(_e,Le,!1))},this.getSize=function(T){return T.set(_e,Le)},this.setSize=function(T,B,K=!0){if(he.isPresenting){nt("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=T,Le=B,t.width=Math.floor(T*Se),t.height=Math.floor(B*Se),K===!0&&(t.style.width=T+"px",t.style.height=B+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,T,B)},this.getDrawingBufferSize=function(T){return T.set(_e*Se,Le*Se).floor()},this.setDrawingBufferSize=function(T,B,K){_e=T,Le=B,Se=K,t.width=Math.floor(T*K),t.height=Math.floor(B*K),this.setViewport(0,0,T,B)},this.setEffects=function(T){if(v===Yn){lt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let B=0;B<T.length;B++)if(T[B].isOutputPass===!0){nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ee)},this.getViewport=function(T){return T.copy(Je)},this.setViewport=function(T,B,K,Y){T.isVector4?Je.set(T.x,T.y,T.z,T.w):Je.set(T,B,K,Y),we.viewport(ee.copy(Je).multiplyScalar(xt()).round())},this.getScissor=function(T){return T.copy(st)},this.setScissor=function(T,B,K,Y){T.isVector4?st.set(T.x,T.y,T.z,T.w):st.set(T,B,K,Y),we.scissor(de.copy(st).multiplyScalar(xt()).round())},this.getScissorTest=function(){return tt},this.setScissorTest=function(T){we.setScissorTest(tt=T)},this.setOpaqueSort=function(T){Ge=T},this.setTransparentSort=function(T){it=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,B=!0,K=!0){let Y=0;if(T){let $=!1;if(le!==null){let Pe=le.texture.format;$=m.has(Pe)}if($){let Pe=le.texture.type,Fe=g.has(Pe),Ie=U.getClearColor(),Ue=U.getClearAlpha(),Ze=Ie.r,ht=Ie.g,yt=Ie.b;Fe?(y[0]=Ze,y[1]=ht,y[2]=yt,y[3]=Ue,F.clearBufferuiv(F.COLOR,0,y)):(A[0]=Ze,A[1]=ht,A[2]=yt,A[3]=Ue,F.clearBufferiv(F.COLOR,0,A))}else Y|=F.COLOR_BUFFER_BIT}B&&(Y|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(Y|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&F.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",qe,!1),t.removeEventListener("webglcontextrestored",ot,!1),t.removeEventListener("webglcontextcreationerror",Ne,!1),U.dispose(),Te.dispose(),te.dispose(),je.dispose(),$e.dispose(),R.dispose(),ue.dispose(),X.dispose(),Ce.dispose(),Ke.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Yo),he.removeEventListener("sessionend",Ui),ji.stop()};function qe(T){T.preventDefault(),Od("WebGLRenderer: Context Lost."),I=!0}function ot(){Od("WebGLRenderer: Context Restored."),I=!1;let T=Dt.autoReset,B=me.enabled,K=me.autoUpdate,Y=me.needsUpdate,$=me.type;at(),Dt.autoReset=T,me.enabled=B,me.autoUpdate=K,me.needsUpdate=Y,me.type=$}function Ne(T){lt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function gt(T){let B=T.target;B.removeEventListener("dispose",gt),Ht(B)}function Ht(T){Nn(T),$e.remove(T)}function Nn(T){let B=$e.get(T).programs;B!==void 0&&(B.forEach(function(K){ae.releaseProgram(K)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,B,K,Y,$,Pe){B===null&&(B=pt);let Fe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ie=Ra(T,B,K,Y,$);we.setMaterial(Y,Fe);let Ue=K.index,Ze=1;if(Y.wireframe===!0){if(Ue=X.getWireframeAttribute(K),Ue===void 0)return;Ze=2}let ht=K.drawRange,yt=K.attributes.position,Ye=ht.start*Ze,bt=(ht.start+ht.count)*Ze;Pe!==null&&(Ye=Math.max(Ye,Pe.start*Ze),bt=Math.min(bt,(Pe.start+Pe.count)*Ze)),Ue!==null?(Ye=Math.max(Ye,0),bt=Math.min(bt,Ue.count)):yt!=null&&(Ye=Math.max(Ye,0),bt=Math.min(bt,yt.count));let Kt=bt-Ye;if(Kt<0||Kt===1/0)return;Ce.setup($,Y,Ie,K,Ue);let Ot,Bt=ne;if(Ue!==null&&(Ot=M.get(Ue),Bt=Re,Bt.setIndex(Ot)),$.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*xt()),Bt.setMode(F.LINES)):Bt.setMode(F.TRIANGLES);else if($.isLine){let dn=Y.linewidth;dn===void 0&&(dn=1),we.setLineWidth(dn*xt()),$.isLineSegments?Bt.setMode(F.LINES):$.isLineLoop?Bt.setMode(F.LINE_LOOP):Bt.setMode(F.LINE_STRIP)}else $.isPoints?Bt.setMode(F.POINTS):$.isSprite&&Bt.setMode(F.TRIANGLES);if($.isBatchedMesh)if(Xe.get("WEBGL_multi_draw"))Bt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let dn=$._multiDrawStarts,He=$._multiDrawCounts,an=$._multiDrawCount,wt=Ue?M.get(Ue).bytesPerElement:1,ts=$e.get(Y).currentProgram.getUniforms();for(let on=0;on<an;on++)ts.setValue(F,"_gl_DrawID",on),Bt.render(dn[on]/wt,He[on])}else if($.isInstancedMesh)Bt.renderInstances(Ye,Kt,$.count);else if(K.isInstancedBufferGeometry){let dn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,He=Math.min(K.instanceCount,dn);Bt.renderInstances(Ye,Kt,He)}else Bt.render(Ye,Kt)};function Aa(T,B,K,Y){k!==null&&T.isNodeMaterial&&k.setObject(Y,T),xe===!0&&ie.setState(T,K,!1),T.transparent===!0&&T.side===Ln&&T.forceSinglePass===!1?(T.side=Xn,T.needsUpdate=!0,Oi(T,B,Y),T.side=Zs,T.needsUpdate=!0,Oi(T,B,Y),T.side=Ln):Oi(T,B,Y)}this.compile=function(T,B,K=null){K===null&&(K=T),k!==null&&k.renderStart(T,B,K),E=te.get(K),E.init(B),w.push(E),K.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),T!==K&&T.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),E.setupLights(),k!==null&&k.updateLights(E.state.lightsArray),Be=this.localClippingEnabled,xe=ie.init(this.clippingPlanes,Be),xe===!0&&ie.setGlobalState(this.clippingPlanes,B),k!==null&&me.render(E.state.shadowsArray,K,B);let Y=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Pe=$.material;if(Pe)if(Array.isArray(Pe))for(let Fe=0;Fe<Pe.length;Fe++){let Ie=Pe[Fe];Aa(Ie,K,B,$),Y.add(Ie)}else Aa(Pe,K,B,$),Y.add(Pe)}),E=w.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(T,B,K=null){let Y=this.compile(T,B,K);return new Promise($=>{function Pe(){if(Y.forEach(function(Fe){let Ue=$e.get(Fe).currentProgram;(Ue===void 0||Ue.isReady())&&Y.delete(Fe)}),Y.size===0){$(T);return}setTimeout(Pe,10)}Xe.get("KHR_parallel_shader_compile")!==null?Pe():setTimeout(Pe,10)})};let br=null;function Bh(T){br&&br(T)}function Yo(){ji.stop()}function Ui(){ji.start()}let ji=new a0;ji.setAnimationLoop(Bh),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(T){br=T,he.setAnimationLoop(T),T===null?ji.stop():ji.start()},he.addEventListener("sessionstart",Yo),he.addEventListener("sessionend",Ui),this.render=function(T,B){if(B!==void 0&&B.isCamera!==!0){lt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(T,B);let K=he.enabled===!0&&he.isPresenting===!0,Y=O!==null&&(le===null||K)&&O.begin(L,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(B),B=he.getCamera()),T.isScene===!0&&T.onBeforeRender(L,T,B,le),E=te.get(T,w.length),E.init(B),E.state.textureUnits=je.getTextureUnits(),w.push(E),De.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?ve.setFromArrayCamera(B):re.setFromProjectionMatrix(De,gi,B.reversedDepth),Be=this.localClippingEnabled,xe=ie.init(this.clippingPlanes,Be),C=Te.get(T,x.length),C.init(),x.push(C),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Fe=L.xr.getDepthSensingMesh();Fe!==null&&es(Fe,B,-1/0,L.sortObjects)}es(T,B,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(E.state.lightsArray),L.sortObjects===!0&&C.sort(Ge,it),ut=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,ut&&U.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),xe===!0&&ie.beginShadows();let $=E.state.shadowsArray;if(me.render($,T,B),xe===!0&&ie.endShadows(),(Y&&O.hasRenderPass())===!1){let Fe=C.opaque,Ie=C.transmissive;if(E.setupLights(),B.isArrayCamera){let Ue=B.cameras;if(Ie.length>0)for(let Ze=0,ht=Ue.length;Ze<ht;Ze++){let yt=Ue[Ze];_i(Fe,Ie,T,yt)}ut&&U.render(T);for(let Ze=0,ht=Ue.length;Ze<ht;Ze++){let yt=Ue[Ze];Ea(C,T,yt,yt.viewport)}}else Ie.length>0&&_i(Fe,Ie,T,B),ut&&U.render(T),Ea(C,T,B)}le!==null&&z===0&&(je.updateMultisampleRenderTarget(le),je.updateRenderTargetMipmap(le)),Y&&O.end(L),T.isScene===!0&&T.onAfterRender(L,T,B),Ce.resetDefaultState(),Z=-1,Q=null,w.pop(),w.length>0?(E=w[w.length-1],je.setTextureUnits(E.state.textureUnits),xe===!0&&ie.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,k!==null&&k.renderEnd()};function es(T,B,K,Y){if(T.visible===!1)return;if(T.layers.test(B.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(B);else if(T.isLight)E.pushLight(T),T.castShadow&&E.pushShadow(T);else if(T.isSprite){let Fe=B.isArrayCamera?ve:re;if(!T.frustumCulled||T.intersectsFrustum(Fe)){Y&&ke.setFromMatrixPosition(T.matrixWorld).applyMatrix4(De);let Ie=ue.update(T),Ue=T.material;Ue.visible&&C.push(T,Ie,Ue,K,ke.z,null,B)}}else if(T.isMesh||T.isLine||T.isPoints){let Fe=B.isArrayCamera?ve:re;if(!T.frustumCulled||T.intersectsFrustum(Fe)){let Ie=ue.update(T),Ue=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ke.copy(T.boundingSphere.center)):(Ie.boundingSphere===null&&Ie.computeBoundingSphere(),ke.copy(Ie.boundingSphere.center)),ke.applyMatrix4(T.matrixWorld).applyMatrix4(De)),Array.isArray(Ue)){let Ze=Ie.groups;for(let ht=0,yt=Ze.length;ht<yt;ht++){let Ye=Ze[ht],bt=Ue[Ye.materialIndex];bt&&bt.visible&&C.push(T,Ie,bt,K,ke.z,Ye,B)}}else Ue.visible&&C.push(T,Ie,Ue,K,ke.z,null,B)}}}let Pe=T.children;for(let Fe=0,Ie=Pe.length;Fe<Ie;Fe++)es(Pe[Fe],B,K,Y)}function Ea(T,B,K,Y){let{opaque:$,transmissive:Pe,transparent:Fe}=T;E.setupLightsView(K),xe===!0&&ie.setGlobalState(L.clippingPlanes,K),Y&&we.viewport(ee.copy(Y)),$.length>0&&jt($,B,K),Pe.length>0&&jt(Pe,B,K),Fe.length>0&&jt(Fe,B,K),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function _i(T,B,K,Y){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let Ye=Xe.has("EXT_color_buffer_half_float")||Xe.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new ai(1,1,{generateMipmaps:!0,type:Ye?Ni:Yn,minFilter:vs,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:At.workingColorSpace})}let Pe=E.state.transmissionRenderTarget[Y.id],Fe=Y.viewport||ee;Pe.setSize(Fe.z*L.transmissionResolutionScale,Fe.w*L.transmissionResolutionScale);let Ie=L.getRenderTarget(),Ue=L.getActiveCubeFace(),Ze=L.getActiveMipmapLevel();L.setRenderTarget(Pe),L.getClearColor(j),ge=L.getClearAlpha(),ge<1&&L.setClearColor(16777215,.5),L.clear(),ut&&U.render(K);let ht=L.toneMapping;L.toneMapping=Ji;let yt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),xe===!0&&ie.setGlobalState(L.clippingPlanes,Y),jt(T,K,Y),je.updateMultisampleRenderTarget(Pe),je.updateRenderTargetMipmap(Pe),Xe.has("WEBGL_multisampled_render_to_texture")===!1){let Ye=!1;for(let bt=0,Kt=B.length;bt<Kt;bt++){let Ot=B[bt],{object:Bt,geometry:dn,material:He,group:an}=Ot;if(He.side===Ln&&Bt.layers.test(Y.layers)){let wt=He.side;He.side=Xn,He.needsUpdate=!0,sn(Bt,K,Y,dn,He,an),He.side=wt,He.needsUpdate=!0,Ye=!0}}Ye===!0&&(je.updateMultisampleRenderTarget(Pe),je.updateRenderTargetMipmap(Pe))}L.setRenderTarget(Ie,Ue,Ze),L.setClearColor(j,ge),yt!==void 0&&(Y.viewport=yt),L.toneMapping=ht}function jt(T,B,K){let Y=B.isScene===!0?B.overrideMaterial:null;for(let $=0,Pe=T.length;$<Pe;$++){let Fe=T[$],{object:Ie,geometry:Ue,group:Ze}=Fe,ht=Fe.material;ht.allowOverride===!0&&Y!==null&&(ht=Y),Ie.layers.test(K.layers)&&sn(Ie,B,K,Ue,ht,Ze)}}function sn(T,B,K,Y,$,Pe){k!==null&&$.isNodeMaterial&&k.setObject(T,$),T.onBeforeRender(L,B,K,Y,$,Pe),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(L,B,K,Y,T,Pe),$.transparent===!0&&$.side===Ln&&$.forceSinglePass===!1?($.side=Xn,$.needsUpdate=!0,L.renderBufferDirect(K,B,Y,$,T,Pe),$.side=Zs,$.needsUpdate=!0,L.renderBufferDirect(K,B,Y,$,T,Pe),$.side=Ln):L.renderBufferDirect(K,B,Y,$,T,Pe),T.onAfterRender(L,B,K,Y,$,Pe)}function rn(T){let B=0;for(let K of T)K.texture!==null&&B++;return B}function Oi(T,B,K){B.isScene!==!0&&(B=pt);let Y=$e.get(T),$=E.state.lights,Pe=E.state.shadowsArray,Fe=$.state.version,Ie=ae.getParameters(T,$.state,Pe,B,K,E.state.lightProbeGridArray),Ue=ae.getProgramCacheKey(Ie),Ze=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let ht=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=R.get(T.envMap||Y.environment,ht),Y.envMapRotation=Y.environment!==null&&T.envMap===null?B.environmentRotation:T.envMapRotation,Ze===void 0&&(T.addEventListener("dispose",gt),Ze=new Map,Y.programs=Ze,Y.programVariants=new Map);let yt=Ze.get(Ue);if(yt!==void 0){if(Y.currentProgram===yt&&Y.lightsStateVersion===Fe)return Ca(T,Ie),yt}else Ie.uniforms=ae.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,K,Ie),T.onBeforeCompile(Ie,L),yt=ae.acquireProgram(Ie,Ue),Ze.set(Ue,yt),Y.uniforms=Ie.uniforms;let Ye=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ye.clippingPlanes=ie.uniform),Ca(T,Ie),Y.needsLights=ws(T),Y.lightsStateVersion=Fe,Y.needsLights&&(Ye.ambientLightColor.value=$.state.ambient,Ye.lightProbe.value=$.state.probe,Ye.sunLights.value=$.state.sun,Ye.sunLightShadows.value=$.state.sunShadow,Ye.directionalLights.value=$.state.directional,Ye.directionalLightShadows.value=$.state.directionalShadow,Ye.spotLights.value=$.state.spot,Ye.spotLightShadows.value=$.state.spotShadow,Ye.rectAreaLights.value=$.state.rectArea,Ye.ltc_1.value=$.state.rectAreaLTC1,Ye.ltc_2.value=$.state.rectAreaLTC2,Ye.pointLights.value=$.state.point,Ye.pointLightShadows.value=$.state.pointShadow,Ye.hemisphereLights.value=$.state.hemi,Ye.sunShadowMatrix.value=$.state.sunShadowMatrix,Ye.sunShadowCascade.value=$.state.sunShadowCascade,Ye.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Ye.spotLightMatrix.value=$.state.spotLightMatrix,Ye.spotLightMap.value=$.state.spotLightMap,Ye.pointShadowMatrix.value=$.state.pointShadowMatrix),Y.numLightProbeGrids=rn(E.state.lightProbeGridArray),Y.currentProgram=yt,Y.uniformsList=null,yt}function $n(T,B,K,Y,$){let Pe=$e.get(T),Fe=Pe.currentProgram.id+","+Y+","+$,Ie=Pe.programVariants.get(Fe);return Ie===void 0?(Ie=Oi(T,B,K),Pe.programVariants.set(Fe,Ie)):(Pe.currentProgram=Ie,Pe.uniformsList=null,Pe.outputColorSpace=Y,Pe.toneMapping=$),Ie}function Ss(T){if(T.uniformsList===null){let B=T.currentProgram.getUniforms();T.uniformsList=Sa.seqWithValue(B.seq,T.uniforms)}return T.uniformsList}function Ca(T,B){let K=$e.get(T);K.outputColorSpace=B.outputColorSpace,K.batching=B.batching,K.batchingColor=B.batchingColor,K.instancing=B.instancing,K.instancingColor=B.instancingColor,K.instancingMorph=B.instancingMorph,K.skinning=B.skinning,K.morphTargets=B.morphTargets,K.morphNormals=B.morphNormals,K.morphColors=B.morphColors,K.morphTargetsCount=B.morphTargetsCount,K.numClippingPlanes=B.numClippingPlanes,K.numIntersection=B.numClipIntersection,K.vertexAlphas=B.vertexAlphas,K.vertexTangents=B.vertexTangents,K.toneMapping=B.toneMapping}function Ra(T,B,K,Y,$){B.isScene!==!0&&(B=pt),je.resetTextureUnits();let Pe=B.fog,Fe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,Ie=le===null?L.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:At.workingColorSpace,Ue=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ze=R.get(Y.envMap||Fe,Ue),ht=Y.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,yt=!!K.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ye=!!K.morphAttributes.position,bt=!!K.morphAttributes.normal,Kt=!!K.morphAttributes.color,Ot=Ji;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Ot=L.toneMapping);let Bt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,dn=Bt!==void 0?Bt.length:0,He=$e.get(Y),an=E.state.lights;if(xe===!0&&(Be===!0||T!==Q)){let kt=T===Q&&Y.id===Z;ie.setState(Y,T,kt)}let wt=!1,ts=!1;Y.version===He.__version?He.needsLights&&He.lightsStateVersion!==an.state.version||$.isBatchedMesh&&He.batching===!1||!$.isBatchedMesh&&He.batching===!0||$.isBatchedMesh&&He.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&He.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&He.instancing===!1||!$.isInstancedMesh&&He.instancing===!0||$.isSkinnedMesh&&He.skinning===!1||!$.isSkinnedMesh&&He.skinning===!0||$.isInstancedMesh&&He.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&He.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&He.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&He.instancingMorph===!1&&$.morphTexture!==null||He.envMap!==Ze||Y.fog===!0&&He.fog!==Pe||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==ie.numPlanes||He.numIntersection!==ie.numIntersection)||He.vertexAlphas!==ht||He.vertexTangents!==yt||He.morphTargets!==Ye||He.morphNormals!==bt||He.morphColors!==Kt||He.morphTargetsCount!==dn||He.numLightProbeGrids!==rn(E.state.lightProbeGridArray)?wt=!0:(He.outputColorSpace!==Ie||He.toneMapping!==Ot)&&(ts=!0):(wt=!0,He.__version=Y.version);let on=He.currentProgram;(wt===!0||ts===!0)&&(on=ts===!0?$n(Y,B,$,Ie,Ot):Oi(Y,B,$),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,on,He));let wr=!1,Bi=!1,ns=!1,_t=on.getUniforms(),en=He.uniforms;if(we.useProgram(on.program)&&(wr=!0,Bi=!0,ns=!0),Y.id!==Z&&(Z=Y.id,Bi=!0),wr||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),_t.setValue(F,"projectionMatrix",T.projectionMatrix),_t.setValue(F,"viewMatrix",T.matrixWorldInverse);let ln=_t.map.cameraPosition;ln!==void 0&&ln.setValue(F,et.setFromMatrixPosition(T.matrixWorld)),ct.logarithmicDepthBuffer&&_t.setValue(F,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&_t.setValue(F,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,Bi=!0,ns=!0)}if(He.needsLights&&(an.state.sunShadowMap.length>0&&_t.setValue(F,"sunShadowMap",an.state.sunShadowMap,je),an.state.directionalShadowMap.length>0&&_t.setValue(F,"directionalShadowMap",an.state.directionalShadowMap,je),an.state.spotShadowMap.length>0&&_t.setValue(F,"spotShadowMap",an.state.spotShadowMap,je),an.state.pointShadowMap.length>0&&_t.setValue(F,"pointShadowMap",an.state.pointShadowMap,je)),$.isSkinnedMesh){_t.setOptional(F,$,"bindMatrix"),_t.setOptional(F,$,"bindMatrixInverse");let kt=$.skeleton;kt&&(kt.boneTexture===null&&kt.computeBoneTexture(),_t.setValue(F,"boneTexture",kt.boneTexture,je))}$.isBatchedMesh&&(_t.setOptional(F,$,"batchingTexture"),_t.setValue(F,"batchingTexture",$._matricesTexture,je),_t.setOptional(F,$,"batchingIdTexture"),_t.setValue(F,"batchingIdTexture",$._indirectTexture,je),_t.setOptional(F,$,"batchingColorTexture"),$._colorsTexture!==null&&_t.setValue(F,"batchingColorTexture",$._colorsTexture,je));let Fn=K.morphAttributes;if((Fn.position!==void 0||Fn.normal!==void 0||Fn.color!==void 0)&&se.update($,K,on),(Bi||He.receiveShadow!==$.receiveShadow)&&(He.receiveShadow=$.receiveShadow,_t.setValue(F,"receiveShadow",$.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(en.envMapIntensity.value=B.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=h1()),Bi){if(_t.setValue(F,"toneMappingExposure",L.toneMappingExposure),He.needsLights&&Mr(en,ns),Pe&&Y.fog===!0&&Me.refreshFogUniforms(en,Pe),Me.refreshMaterialUniforms(en,Y,Se,Le,E.state.transmissionRenderTarget[T.id]),He.needsLights&&He.numLightProbeGrids>0){let kt=b,ln=0;for(let Cn of E.state.lightProbeGridArray)Cn.texture!==null&&(kt.textures[ln]=Cn.texture,kt.min[ln]=Cn.boundingBox.min,kt.max[ln]=Cn.boundingBox.max,kt.resolution[ln]=Cn.resolution,ln++);for(let Cn in kt)kt[Cn].length=ln;en.probesSH.value=kt.textures,en.probesMin.value=kt.min,en.probesMax.value=kt.max,en.probesResolution.value=kt.resolution}Sa.upload(F,Ss(He),en,je)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Sa.upload(F,Ss(He),en,je),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&_t.setValue(F,"center",$.center),_t.setValue(F,"modelViewMatrix",$.modelViewMatrix),_t.setValue(F,"normalMatrix",$.normalMatrix),_t.setValue(F,"modelMatrix",$.matrixWorld),Y.uniformsGroups!==void 0){let kt=Y.uniformsGroups;for(let ln=0,Cn=kt.length;ln<Cn;ln++){let $o=kt[ln];Ke.update($o,on),Ke.bind($o,on)}}return on}function Mr(T,B){T.ambientLightColor.needsUpdate=B,T.lightProbe.needsUpdate=B,T.sunLights.needsUpdate=B,T.sunLightShadows.needsUpdate=B,T.directionalLights.needsUpdate=B,T.directionalLightShadows.needsUpdate=B,T.pointLights.needsUpdate=B,T.pointLightShadows.needsUpdate=B,T.spotLights.needsUpdate=B,T.spotLightShadows.needsUpdate=B,T.rectAreaLights.needsUpdate=B,T.hemisphereLights.needsUpdate=B}function ws(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,B,K){let Y=$e.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),$e.get(T.texture).__webglTexture=B,$e.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:K,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,B){let K=$e.get(T);K.__webglFramebuffer=B,K.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(T,B=0,K=0){le=T,q=B,z=K;let Y=null,$=!1,Pe=!1;if(T){let Ie=$e.get(T);if(Ie.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Ie.__webglFramebuffer),ee.copy(T.viewport),de.copy(T.scissor),ce=T.scissorTest,we.viewport(ee),we.scissor(de),we.setScissorTest(ce),Z=-1;return}else if(Ie.__webglFramebuffer===void 0)je.setupRenderTarget(T);else if(Ie.__hasExternalTextures)je.rebindTextures(T,$e.get(T.texture).__webglTexture,$e.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let ht=T.depthTexture;if(Ie.__boundDepthTexture!==ht){if(ht!==null&&$e.has(ht)&&(T.width!==ht.image.width||T.height!==ht.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(T)}}let Ue=T.texture;(Ue.isData3DTexture||Ue.isDataArrayTexture||Ue.isCompressedArrayTexture)&&(Pe=!0);let Ze=$e.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ze[B])?Y=Ze[B][K]:Y=Ze[B],$=!0):T.samples>0&&je.useMultisampledRTT(T)===!1?Y=$e.get(T).__webglMultisampledFramebuffer:Array.isArray(Ze)?Y=Ze[K]:Y=Ze,ee.copy(T.viewport),de.copy(T.scissor),ce=T.scissorTest}else ee.copy(Je).multiplyScalar(Se).floor(),de.copy(st).multiplyScalar(Se).floor(),ce=tt;if(K!==0&&(Y=H),we.bindFramebuffer(F.FRAMEBUFFER,Y)&&we.drawBuffers(T,Y),we.viewport(ee),we.scissor(de),we.setScissorTest(ce),$){let Ie=$e.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ie.__webglTexture,K)}else if(Pe){let Ie=B;for(let Ue=0;Ue<T.textures.length;Ue++){let Ze=$e.get(T.textures[Ue]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ue,Ze.__webglTexture,K,Ie)}}else if(T!==null&&K!==0){let Ie=$e.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ie.__webglTexture,K)}Z=-1};function Sr(T){let B=$e.get(T);return(B.__readFormat!==T.format||B.__readType!==T.type)&&(B.__readFormat=T.format,B.__readType=T.type,B.__formatReadable=ct.textureFormatReadable(T.format),B.__typeReadable=ct.textureTypeReadable(T.type)),B}this.readRenderTargetPixels=function(T,B,K,Y,$,Pe,Fe,Ie=0){if(!(T&&T.isWebGLRenderTarget)){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ue=$e.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ue=Ue[Fe],Array.isArray(Ue)&&(Ue=Ue[0])),Ue){we.bindFramebuffer(F.FRAMEBUFFER,Ue);try{let Ze=T.textures[Ie],ht=Ze.format,yt=Ze.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie);let Ye=Sr(Ze);if(Ye.__formatReadable===!1){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ye.__typeReadable===!1){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=T.width-Y&&K>=0&&K<=T.height-$&&F.readPixels(B,K,Y,$,ye.convert(ht),ye.convert(yt),Pe)}finally{let Ze=le!==null?$e.get(le).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Ze)}}},this.readRenderTargetPixelsAsync=async function(T,B,K,Y,$,Pe,Fe,Ie=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ue=$e.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ue=Ue[Fe],Array.isArray(Ue)&&(Ue=Ue[0])),Ue)if(B>=0&&B<=T.width-Y&&K>=0&&K<=T.height-$){we.bindFramebuffer(F.FRAMEBUFFER,Ue);let Ze=T.textures[Ie],ht=Ze.format,yt=Ze.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie);let Ye=Sr(Ze);if(Ye.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ye.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let bt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,bt),F.bufferData(F.PIXEL_PACK_BUFFER,Pe.byteLength,F.STREAM_READ),F.readPixels(B,K,Y,$,ye.convert(ht),ye.convert(yt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Kt=le!==null?$e.get(le).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Kt);let Ot=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Cg(F,Ot,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,bt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Pe),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(bt),F.deleteSync(Ot),Pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,B=null,K=0){let Y=Math.pow(2,-K),$=Math.floor(T.image.width*Y),Pe=Math.floor(T.image.height*Y),Fe=B!==null?B.x:0,Ie=B!==null?B.y:0;je.setTexture2D(T,0),F.copyTexSubImage2D(F.TEXTURE_2D,K,0,0,Fe,Ie,$,Pe),we.unbindTexture()},this.copyTextureToTexture=function(T,B,K=null,Y=null,$=0,Pe=0){let Fe,Ie,Ue,Ze,ht,yt,Ye,bt,Kt,Ot=T.isCompressedTexture?T.mipmaps[Pe]:T.image;if(K!==null)Fe=K.max.x-K.min.x,Ie=K.max.y-K.min.y,Ue=K.isBox3?K.max.z-K.min.z:1,Ze=K.min.x,ht=K.min.y,yt=K.isBox3?K.min.z:0;else{let _t=Math.pow(2,-$);Fe=Math.floor(Ot.width*_t),Ie=Math.floor(Ot.height*_t),T.isDataArrayTexture?Ue=Ot.depth:T.isData3DTexture?Ue=Math.floor(Ot.depth*_t):Ue=1,Ze=0,ht=0,yt=0}Y!==null?(Ye=Y.x,bt=Y.y,Kt=Y.z):(Ye=0,bt=0,Kt=0);let Bt=ye.convert(B.format),dn=ye.convert(B.type),He;B.isData3DTexture?(je.setTexture3D(B,0),He=F.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(je.setTexture2DArray(B,0),He=F.TEXTURE_2D_ARRAY):(je.setTexture2D(B,0),He=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,B.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,B.unpackAlignment);let an=we.getParameter(F.UNPACK_ROW_LENGTH),wt=we.getParameter(F.UNPACK_IMAGE_HEIGHT),ts=we.getParameter(F.UNPACK_SKIP_PIXELS),on=we.getParameter(F.UNPACK_SKIP_ROWS),wr=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,Ot.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ot.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ze),we.pixelStorei(F.UNPACK_SKIP_ROWS,ht),we.pixelStorei(F.UNPACK_SKIP_IMAGES,yt);let Bi=T.isDataArrayTexture||T.isData3DTexture,ns=B.isDataArrayTexture||B.isData3DTexture;if(T.isDepthTexture){let _t=$e.get(T),en=$e.get(B),Fn=$e.get(_t.__renderTarget),kt=$e.get(en.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,Fn.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,kt.__webglFramebuffer);for(let ln=0;ln<Ue;ln++)Bi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.get(T).__webglTexture,$,yt+ln),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.get(B).__webglTexture,Pe,Kt+ln)),F.blitFramebuffer(Ze,ht,Ze+Fe,ht+Ie,Ye,bt,Ye+Fe,bt+Ie,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||$e.has(T)){let _t=$e.get(T),en=$e.get(B);we.bindFramebuffer(F.READ_FRAMEBUFFER,D),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,V);for(let Fn=0;Fn<Ue;Fn++)Bi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,_t.__webglTexture,$,yt+Fn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,_t.__webglTexture,$),ns?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,en.__webglTexture,Pe,Kt+Fn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,en.__webglTexture,Pe),$!==0?F.blitFramebuffer(Ze,ht,Ze+Fe,ht+Ie,Ye,bt,Ye+Fe,bt+Ie,F.COLOR_BUFFER_BIT,F.NEAREST):ns?F.copyTexSubImage3D(He,Pe,Ye,bt,Kt+Fn,Ze,ht,Fe,Ie):F.copyTexSubImage2D(He,Pe,Ye,bt,Ze,ht,Fe,Ie);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ns?T.isDataTexture||T.isData3DTexture?F.texSubImage3D(He,Pe,Ye,bt,Kt,Fe,Ie,Ue,Bt,dn,Ot.data):B.isCompressedArrayTexture?F.compressedTexSubImage3D(He,Pe,Ye,bt,Kt,Fe,Ie,Ue,Bt,Ot.data):F.texSubImage3D(He,Pe,Ye,bt,Kt,Fe,Ie,Ue,Bt,dn,Ot):T.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Pe,Ye,bt,Fe,Ie,Bt,dn,Ot.data):T.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Pe,Ye,bt,Ot.width,Ot.height,Bt,Ot.data):F.texSubImage2D(F.TEXTURE_2D,Pe,Ye,bt,Fe,Ie,Bt,dn,Ot);we.pixelStorei(F.UNPACK_ROW_LENGTH,an),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,wt),we.pixelStorei(F.UNPACK_SKIP_PIXELS,ts),we.pixelStorei(F.UNPACK_SKIP_ROWS,on),we.pixelStorei(F.UNPACK_SKIP_IMAGES,wr),Pe===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&F.generateMipmap(He),we.unbindTexture()},this.initRenderTarget=function(T){$e.get(T).__webglFramebuffer===void 0&&je.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?je.setTextureCube(T,0):T.isData3DTexture?je.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?je.setTexture2DArray(T,0):je.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){q=0,z=0,le=null,we.reset(),Ce.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=At._getDrawingBufferColorSpace(e),t.unpackColorSpace=At._getUnpackColorSpace()}};var x0="#f4efe2";function _0(i){let e=document.createElement("canvas");e.width=512,e.height=256;let t=e.getContext("2d");if(!t)return e;if(t.fillStyle=i.striped?x0:i.colour,t.fillRect(0,0,512,256),i.striped&&(t.fillStyle=i.colour,t.fillRect(0,256*(.5-.2),512,2*.2*256)),i.spotted&&d1(t,"#c4202b"),i.label)for(let n of[.25,.75])u1(t,n*512,256/2,i.label);return e}function u1(i,e,t,n){i.fillStyle=x0,i.beginPath(),i.arc(e,t,.155*256,0,2*Math.PI),i.fill();let s=n.length>2?30:n.length>1?46:56;i.fillStyle="#16181a",i.font=`700 ${s}px "Helvetica Neue", Arial, "Liberation Sans", sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillText(n,e,t+.04*s,2*.155*256*.82),/^[69]$/.test(n)&&i.fillRect(e-.3*s,t+.44*s,.6*s,3)}function d1(i,e){i.fillStyle=e;for(let n of[0,.25,.5,.75,1])i.beginPath(),i.arc(n*512,256/2,12.8,0,2*Math.PI),i.fill();i.fillRect(0,0,512,12.8),i.fillRect(0,256-12.8,512,12.8)}var f1=`
varying vec3 polishNormal;
varying vec3 polishAt;
void main() {`,p1=`
  vec4 polishPlace = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
    polishPlace = instanceMatrix * polishPlace;
  #endif
  polishAt = (modelMatrix * polishPlace).xyz;
  polishNormal = inverseTransformDirection(transformedNormal, viewMatrix);
}`;function m1(i,e){let{cloth:t,floor:n}=i,[s,r]=[(t.x0+t.x1)/2,(t.y0+t.y1)/2],[a,o]=[t.x1-t.x0,t.y1-t.y0],l=Math.max(a,o),c=u=>u.toFixed(5),h=o>=a?[.12,.5]:[.5,.12];return`
varying vec3 polishNormal;
varying vec3 polishAt;
vec3 polishRoom(vec3 at, vec3 ray) {
  vec3 seen = mix(vec3(0.04, 0.07, 0.055), vec3(0.34, 0.33, 0.31), smoothstep(-0.15, 0.5, ray.z));
  if (ray.z > 0.02) {
    vec2 hit = (at.xy - vec2(${c(s)}, ${c(r)}) + ray.xy * (${c(.55*l+n)} - at.z) / ray.z) / ${c(l)};
    vec2 off = abs(hit) - vec2(${c(h[0])}, ${c(h[1])});
    seen += 13.0 * smoothstep(${c(e)}, ${c(-e)}, max(off.x, off.y)) * vec3(1.0, 0.95, 0.86);
  }
  return seen;
}`}function Ih(i,e,t,n){let s=i.onBeforeCompile.bind(i);i.onBeforeCompile=(r,a)=>{s(r,a),r.vertexShader=r.vertexShader.replace("void main() {",f1).replace(/\}\s*$/,p1),r.fragmentShader=r.fragmentShader.replace("void main() {",`${m1(e,n)}
void main() {`).replace("#include <opaque_fragment>",`vec3 polishFrom = normalize(polishAt - cameraPosition);
       vec3 polishUp = normalize(polishNormal);
       float polishMirror = 0.04 + 0.96 * pow(1.0 - clamp(dot(-polishFrom, polishUp), 0.0, 1.0), 5.0);
       outgoingLight += ${t.toFixed(3)} * polishMirror * polishRoom(polishAt, reflect(polishFrom, polishUp));
       #include <opaque_fragment>`)},i.customProgramCacheKey=()=>`polish ${t} ${n}`}function v0(i){let e=i>>>0;return()=>(e=Math.imul(e,1664525)+1013904223>>>0,e/4294967296)}function ef(i,e){let t=document.createElement("canvas");return t.width=i,t.height=e,[t,t.getContext("2d")]}function y0(i){let e=new Hs(i);return e.wrapS=fr,e.wrapT=fr,e.colorSpace=En,e.anisotropy=8,e}function b0(){let[i,e]=[1024,128],[t,n]=ef(i,e);if(n){let s=v0(7);n.fillStyle="#6b3a20",n.fillRect(0,0,i,e);for(let r=0;r<420;r+=1){let a=s()*e,o=s()<.6;n.strokeStyle=o?`rgba(28,10,4,${.05+.16*s()})`:`rgba(190,110,60,${.03+.1*s()})`,n.lineWidth=.5+1.6*s();let[l,c,h]=[1+3*s(),1+Math.floor(2*s()),6.3*s()];n.beginPath();for(let u=0;u<=i;u+=16)n.lineTo(u,a+l*Math.sin(h+c*2*Math.PI*u/i));n.stroke()}}return y0(t)}function M0(){let[e,t]=ef(256,256);if(t){let n=v0(11);t.fillStyle="#e9e9e9",t.fillRect(0,0,256,256);for(let s=0;s<9e3;s+=1){let r=n()<.5?0:255;t.fillStyle=`rgba(${r},${r},${r},${.05*n()+.01})`,t.fillRect(n()*256,n()*256,1+2*n(),1)}}return y0(e)}function S0(){let[e,t]=ef(64,64);if(t){let n=t.createRadialGradient(32,32,0,32,32,32);n.addColorStop(0,"rgba(0,0,0,0.75)"),n.addColorStop(.45,"rgba(0,0,0,0.5)"),n.addColorStop(1,"rgba(0,0,0,0)"),t.fillStyle=n,t.fillRect(0,0,64,64)}return new Hs(e)}var nf=64,g1=.12,[Ks,x1,tf,Go]=[new W,new W,new Gn,new Ct],T0=new Ct().makeScale(0,0,0),Lh=class{constructor(e){this.stage=e;let{balls:t}=e.data,n=t.length>nf,s=n?new mr(1,20,14):new mr(1,48,32);n?(this.instances=new Ii(s,w0(e,{}),t.length),t.forEach((a,o)=>this.instances?.setColorAt(o,new mt(Rs(a.id,o).colour))),this.instances.castShadow=!0,this.instances.frustumCulled=!1,this.group.add(this.instances)):t.forEach((a,o)=>{let l=new Hs(_0(Rs(a.id,o)));l.colorSpace=En,l.anisotropy=8;let c=new Ut(s,w0(e,{map:l}));c.castShadow=!0,c.receiveShadow=!0,this.meshes.push(c),this.group.add(c)});let r=new Pi({map:S0(),transparent:!0,depthWrite:!1,opacity:.8});this.shades=new Ii(new Li(2.5,2.5),r,t.length),this.shades.frustumCulled=!1,this.shades.renderOrder=1,this.group.add(this.shades)}stage;group=new ri;meshes=[];instances=null;shades;show(e,t,n,s){let{stage:r,meshes:a,instances:o,shades:l}=this,{positions:c,orientations:h,present:u,run:d}=e;r.radii.forEach((f,p)=>{Ks.fromArray(c,3*p);let v=u[p]?0:(n-d.leaves[p])/(g1*s),m=v>=0&&v<1;Ks.z-=2.2*f*Math.max(0,v)**2,tf.fromArray(h,4*p).multiply(t),Go.compose(Ks,tf,x1.setScalar(m?f:0)),o?o.setMatrixAt(p,Go):(a[p].visible=m,a[p].position.copy(Ks),a[p].quaternion.copy(tf),a[p].scale.setScalar(f)),u[p]&&Go.makeScale(f,f,f).setPosition(Ks.x,Ks.y,r.floor+.02),l.setMatrixAt(p,u[p]?Go:T0)}),l.instanceMatrix.needsUpdate=!0,o&&(o.instanceMatrix.needsUpdate=!0)}};function w0(i,e){let t=new li(e);return Ih(t,i,1,.012),t}var _1=`
attribute float seen;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec4 at = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  normalSeen = normalize(mat3(modelViewMatrix) * mat3(instanceMatrix) * normal);
  toEye = normalize(-at.xyz);
  amount = seen;
  gl_Position = projectionMatrix * at;
}`,v1=`
uniform vec3 colour;
uniform float beats;
varying vec3 normalSeen;
varying vec3 toEye;
varying float amount;
void main() {
  vec3 n = normalize(normalSeen);
  float facing = clamp(dot(n, normalize(toEye)), 0.0, 1.0);
  float rim = smoothstep(0.62, 0.42, facing);
  float beat = beats < 0.5 ? 1.0 : smoothstep(0.22, 0.3, abs(fract(atan(n.y, n.x) / 6.2831853 * beats) - 0.5));
  float alpha = amount * max(0.3, rim * mix(0.35, 1.0, beat));
  gl_FragColor = vec4(mix(colour, vec3(1.0), 0.15 * facing), alpha);
  #include <colorspace_fragment>
}`,Dh=class{constructor(e,t){this.stage=e;let n=e.data.balls.length,{cloth:s,beats:r}=Qn(t),a=new Wn({vertexShader:_1,fragmentShader:v1,uniforms:{colour:{value:new mt(s)},beats:{value:r}},transparent:!0,depthWrite:!1}),o=new mr(1,n>nf?18:36,n>nf?12:24);this.seen=new gs(new Float32Array(n),1),this.seen.setUsage(Fd),o.setAttribute("seen",this.seen),this.mesh=new Ii(o,a,n),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}stage;mesh;seen;show(e,t){let{mesh:n,seen:s,stage:r}=this;r.radii.forEach((a,o)=>{let[l,c]=[e.present[o]===1,t.present[o]===1],h=l?c?il(e.positions,t.positions,o):1:0;s.array[o]=h,Ks.fromArray(e.positions,3*o),n.setMatrixAt(o,h>0?Go.makeScale(1.02*a,1.02*a,1.02*a).setPosition(Ks):T0)}),s.needsUpdate=!0,n.instanceMatrix.needsUpdate=!0}},Nh=class{constructor(e){this.stage=e;let t=new Pi({color:"#ffe98a",transparent:!0,opacity:.95,depthTest:!1,depthWrite:!1}),n=new _s(1.02,1.2,64);this.called=Array.from({length:8},()=>new Ut(n,t)),this.chosen=new Ut(new _s(1.12,1.2,64),new Pi({color:"#ffffff",transparent:!0,opacity:.7,depthWrite:!1})),this.called.forEach(s=>s.renderOrder=5),this.group.add(...this.called,this.chosen)}stage;group=new ri;called;chosen;show(e,t,n){this.called.forEach((s,r)=>this.put(s,e,t[r]??-1)),this.put(this.chosen,e,n)}put(e,t,n){if(e.visible=n>=0&&t.present[n]===1,e.visible){let s=this.stage.radii[n];e.scale.setScalar(s),e.position.set(t.positions[3*n],t.positions[3*n+1],this.stage.floor+.03)}}};var A0=26,y1=.92,b1=1.5,M1=420,Fh=class{constructor(e,t,n){this.sight=e;this.floor=t;this.still=n}sight;floor;still;pose={tilt:0,turn:0,zoom:1,x:0,y:0};from=null;goal=null;began=0;lying=!0;look(e){this.to({tilt:e==="above"?0:y1,turn:e==="above"?0:-.2,zoom:1,x:0,y:0})}close(e){let{tilt:t,turn:n}=this.goal??this.pose;this.to({tilt:t,turn:n,...e?tl(this.sight,e):{zoom:1,x:0,y:0}})}orbit(e,t){let n=this.settle();n.turn+=e,n.tilt=Math.min(b1,Math.max(0,n.tilt+t))}zoom(e){let t=this.settle();t.zoom=Math.min(2,Math.max(.04,t.zoom*e))}pan(e,t,n){let s=this.settle(),r=2*Math.tan(A0*Math.PI/360)*n.position.distanceTo(this.target(new W)),a=this.heading();s.x+=r*(e*Math.sin(a)+t*Math.cos(a)),s.y+=r*(-e*Math.cos(a)+t*Math.sin(a))}place(e,t){let n=this.ease(t),s=this.heading(),{tilt:r,zoom:a}=this.pose,o=new W(Math.cos(s),Math.sin(s),0),l=o.clone().multiplyScalar(-Math.sin(r));l.z=Math.cos(r);let c=o.clone().multiplyScalar(Math.cos(r));c.z=Math.sin(r);let h=new W(Math.sin(s),-Math.cos(s),0),u=this.target(new W),d=this.fit(e.aspect,h,c,l);return u.addScaledVector(c,d.rise*a),e.up.copy(c),e.position.copy(u).addScaledVector(l,d.distance*a),e.near=Math.max(.05,.02*d.distance*a),e.far=6*d.distance*Math.max(1,a)+50,e.lookAt(u),e.updateProjectionMatrix(),e.updateMatrixWorld(),n}heading(){return(this.lying?Math.PI:Math.PI/2)+this.pose.turn}target(e){let{sight:t,floor:n,pose:s}=this;return e.set((t.x0+t.x1)/2+s.x,(t.y0+t.y1)/2+s.y,n)}fit(e,t,n,s){let{sight:r}=this,[a,o]=[(r.x1-r.x0)/2,(r.y1-r.y0)/2],l=Math.tan(A0*Math.PI/360),c=l*e,u=[-1,1].flatMap(p=>[-1,1].flatMap(v=>[-2.6,2].map(m=>new W(p*a,v*o,m)))).map(p=>({x:p.dot(t),y:p.dot(n),z:p.dot(s)})),d=0,f=0;for(let p=0;p<6;p+=1){f=Math.max(...u.map(m=>m.z+Math.max(Math.abs(m.x)/c,Math.abs(m.y-d)/l)));let v=u.map(m=>(m.y-d)/(f-m.z));d+=(Math.max(...v)+Math.min(...v))/2*f*.8}return f=Math.max(...u.map(p=>p.z+Math.max(Math.abs(p.x)/c,Math.abs(p.y-d)/l))),{distance:f*1.04,rise:d}}to(e){if(this.still()){this.pose=e,this.goal=null;return}this.from={...this.pose},this.goal=e,this.began=performance.now()}settle(){return this.goal=null,this.pose}ease(e){let{from:t,goal:n}=this;if(!t||!n)return!1;let s=Math.min(1,Math.max(0,(e-this.began)/M1)),r=s*s*(3-2*s),a=(o,l)=>o+r*(l-o);return this.pose={tilt:a(t.tilt,n.tilt),turn:a(t.turn,n.turn),zoom:a(t.zoom,n.zoom),x:a(t.x,n.x),y:a(t.y,n.y)},s>=1&&(this.goal=null),s<1}};var S1=.2,w1=`
attribute float when;
attribute float way;
attribute vec3 tint;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  whenSeen = when;
  waySeen = way;
  tintSeen = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,T1=`
uniform float now;
uniform float fade;
uniform float dash;
uniform float strength;
varying float whenSeen;
varying float waySeen;
varying vec3 tintSeen;
void main() {
  if (whenSeen > now || (dash > 0.0 && fract(waySeen / dash) > 0.6)) discard;
  float age = (now - whenSeen) / fade;
  gl_FragColor = vec4(tintSeen, strength * (0.3 + 0.7 * exp(-age)));
  #include <colorspace_fragment>
}`,Uh=class{mesh;material;constructor(e,t,n){let[s,r,a,o,l]=[[],[],[],[],[]],c=e.floor+(n?.016:.012);t.paths.forEach((d,f)=>{let p=n?new mt(Qn(t.index).cloth):new mt(Rs(e.data.balls[f].id,f).colour).lerp(new mt("#ffffff"),.25),v=Qo(d,t.leaves[f]),m=0;for(let g=0;g+5<v.length;g+=3){let[y,A,b,C,E,x]=v.subarray(g,g+6),w=Math.hypot(E-A,x-b);if(w<1e-6)continue;let O=S1/2*(n?.8:1),[L,I]=[-(x-b)/w*O,(E-A)/w*O],k=s.length/3;s.push(A+L,b+I,c,A-L,b-I,c,E+L,x+I,c,E-L,x-I,c),r.push(y,y,C,C),a.push(m,m,m+w,m+w),o.push(...[0,1,2,3].flatMap(()=>[p.r,p.g,p.b])),l.push(k,k+1,k+2,k+2,k+1,k+3),m+=w}});let h=new Sn;h.setAttribute("position",new Et(s,3)),h.setAttribute("when",new Et(r,1)),h.setAttribute("way",new Et(a,1)),h.setAttribute("tint",new Et(o,3)),h.setIndex(l);let u=Math.max(1e-9,e.end/5);this.material=new Wn({vertexShader:w1,fragmentShader:T1,uniforms:{now:{value:0},fade:{value:u},dash:{value:n?1.4:0},strength:{value:n?.85:.8}},transparent:!0,depthWrite:!1,side:Ln}),this.mesh=new Ut(h,this.material),this.mesh.frustumCulled=!1,this.mesh.renderOrder=2}show(e){this.material.uniforms.now.value=e}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}},A1=`
attribute float when;
uniform float now;
uniform float life;
uniform float grows;
varying vec2 at;
varying float age;
void main() {
  age = (now - when) / life;
  at = position.xy;
  float size = age < 0.0 || age > 1.0 ? 0.0 : 1.0 + grows * 0.9 * age;
  gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position.xy * size, position.z, 1.0);
}`,E1=`
varying vec2 at;
varying float age;
void main() {
  float d = length(at);
  float ring = smoothstep(0.7, 0.76, d) * smoothstep(1.0, 0.94, d);
  if (ring < 0.01) discard;
  gl_FragColor = vec4(1.0, 0.97, 0.85, ring * (1.0 - age) * 0.9);
}`,Oh=class{mesh;material;constructor(e,t,n){let s=jo(e,t);this.material=new Wn({vertexShader:A1,fragmentShader:E1,uniforms:{now:{value:0},life:{value:Na},grows:{value:n?0:1}},transparent:!0,depthWrite:!1});let r=new Li(2,2);r.setAttribute("when",new gs(Float32Array.from(s,a=>a.at),1)),this.mesh=new Ii(r,this.material,Math.max(1,s.length)),this.mesh.count=s.length,this.mesh.frustumCulled=!1,this.mesh.renderOrder=3,s.forEach((a,o)=>this.mesh.setMatrixAt(o,new Ct().makeScale(a.r,a.r,1).setPosition(a.x,a.y,e.floor+.025)))}show(e,t){this.material.uniforms.now.value=e,this.material.uniforms.life.value=Na*t}dispose(){this.mesh.geometry.dispose(),this.material.dispose()}};var C1="#12694f",R1="#0f6048",E0=1.28,Ta=1.62,P1=.3,I1=.45;function C0(i){let e=new ri;e.position.z=i.floor,e.add(L1(i)),i.table&&e.add(N1(i.table,i),U1(i.table,i),B1(i.table,i));for(let t of i.pockets)e.add(...k1(t.x,t.y,t.r));return e}function L1(i){let e=i.table?qn(i.cloth,1.25+.5*2.9):i.cloth,t=new Xs([new Ee(e.x0,e.y0),new Ee(e.x1,e.y0),new Ee(e.x1,e.y1),new Ee(e.x0,e.y1)]),n=(o,l,c)=>o-c>e.x0&&o+c<e.x1&&l-c>e.y0&&l+c<e.y1;for(let{x:o,y:l,r:c}of i.pockets.filter(h=>n(h.x,h.y,h.r)))t.holes.push(new Ws().absarc(o,l,c,0,2*Math.PI,!0));let s=M0();s.repeat.set(1/9,1/9);let r=new li({color:C1,map:s});D1(r,i.cloth);let a=new Ut(new Mo(t,40),r);return a.receiveShadow=!0,a}function D1(i,e){let t=(r,a)=>`vec2(${r.toFixed(5)}, ${a.toFixed(5)})`,n=t((e.x0+e.x1)/2,(e.y0+e.y1)/2),s=t((e.x1-e.x0)/2,(e.y1-e.y0)/2);i.onBeforeCompile=r=>{r.vertexShader=r.vertexShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
litAt = position.xy;`),r.fragmentShader=r.fragmentShader.replace("#include <common>",`#include <common>
varying vec2 litAt;`).replace("#include <map_fragment>",`#include <map_fragment>
       vec2 off = abs(litAt - ${n}) / ${s};
       diffuseColor.rgb *= mix(1.12, 0.66, smoothstep(0.25, 1.5, length(off)));`)}}function N1(i,e){let t=e.pockets.map(a=>({...a,r:a.r+P1})),n=[];for(let a of Dr(i,t).straights)F1(a,n);let s=new Sn;s.setAttribute("position",new Et(n,3)),s.computeVertexNormals();let r=new Ut(s,new li({color:R1,side:Ln}));return r.castShadow=!0,r.receiveShadow=!0,r}function F1(i,e){let{x0:t,y0:n,x1:s,y1:r}=i,a=Math.hypot(s-t,r-n),[o,l]=[(s-t)/a,(r-n)/a],[c,h]=[l,-o],u=g=>(g?I1:1)*1.25,d=(g,y,A)=>[t+g*o+y*c,n+g*l+y*h,A],f=[[.22,0],[0,E0-.2],[.1,E0],[1.25,Ta-.02],[1.25,0]],p=g=>-g/1.25*u(i.pocketBefore),v=g=>a+g/1.25*u(i.pocketAfter),m=(g,y,A,b)=>{e.push(...g,...y,...A,...g,...A,...b)};for(let g=0;g<3;g+=1){let[[y,A],[b,C]]=[f[g],f[g+1]];m(d(p(y),y,A),d(p(b),b,C),d(v(b),b,C),d(v(y),y,A))}for(let g of[p,v]){let[y,A,b,C,E]=f.map(([x,w])=>d(g(x),x,w));m(y,A,b,C),e.push(...y,...C,...E)}}function U1(i,e){let t=qn(i,1.25+2.9),n=2.4,s=new Xs;s.moveTo(t.x0+n,t.y0);for(let[h,u,d]of[[t.x1-n,t.y0+n,-.5],[t.x1-n,t.y1-n,0],[t.x0+n,t.y1-n,.5],[t.x0+n,t.y0+n,1]])s.absarc(h,u,n,d*Math.PI,(d+.5)*Math.PI,!1);let r=Dr(qn(i,1.25),R0(e)).points;s.holes.push(new Ws(r.map(([h,u])=>new Ee(h,u)).reverse()));let a=.22,o=new bo(s,{depth:Ta+3-2*a,bevelSize:a,bevelThickness:a,bevelOffset:-a,bevelSegments:3,curveSegments:12});o.translate(0,0,-3+a);let l=new li({map:b0()});O1(l,i),Ih(l,e,.55,.12);let c=new Ut(o,l);return c.castShadow=!0,c.receiveShadow=!0,c}function O1(i,e){let t=[(e.x0+e.x1)/2,(e.y0+e.y1)/2],n=[(e.x1-e.x0)/2,(e.y1-e.y0)/2],s=r=>`vec2(${r.map(a=>a.toFixed(6)).join(",")})`;i.onBeforeCompile=r=>{r.vertexShader=r.vertexShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <begin_vertex>",`#include <begin_vertex>
grainAt = position;`),r.fragmentShader=r.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 grainAt;`).replace("#include <map_fragment>",`vec2 far = abs(grainAt.xy - ${s(t)}) - ${s(n)};
       vec2 grainUv = far.x > far.y ? vec2(grainAt.y / 34.0, (grainAt.x + grainAt.z) / 7.0) : vec2(grainAt.x / 34.0 + 0.37, (grainAt.y + grainAt.z) / 7.0);
       diffuseColor *= texture2D(map, grainUv);`)}}function R0(i){return i.pockets.map(e=>({...e,r:e.r+.1}))}function B1(i,e){let[t,n]=[i.x1-i.x0,i.y1-i.y0],s=Math.min(t,n)/4,r=1.25+.55*2.9,a=[],[o,l]=[Math.min(64,Math.round(t/s)),Math.min(64,Math.round(n/s))];for(let u=1;u<o;u+=1)a.push([i.x0+t*u/o,i.y0-r],[i.x0+t*u/o,i.y1+r]);for(let u=1;u<l;u+=1)a.push([i.x0-r,i.y0+n*u/l],[i.x1+r,i.y0+n*u/l]);let c=a.filter(([u,d])=>e.pockets.every(f=>Math.hypot(f.x-u,f.y-d)>f.r+1.6)),h=new Ii(new fa(.26,4),new li({color:"#efe6d2"}),Math.max(1,c.length));return h.count=c.length,c.forEach(([u,d],f)=>h.setMatrixAt(f,new Ct().makeTranslation(u,d,Ta+.012))),h}function k1(i,e,t){let n=new Ut(new pa(t,t*.92,2.6,40,1,!0).rotateX(Math.PI/2),new li({color:"#15110e",side:Ln}));n.position.set(i,e,-1.3);let s=new Ut(new fa(t,40),new Pi({color:"#050505"}));s.position.set(i,e,-2.5);let r=new Ut(new _s(t*.985,t*1.06,48),new li({color:"#0b0a09"}));return r.position.set(i,e,.012),[n,s,r]}function P0(i){let e=new ri;if(e.position.z=i.floor,!i.table)return e;let t=new li({color:"#17130f",side:Ln});for(let n of Dr(qn(i.table,1.25),R0(i)).arcs){let{x:s,y:r,r:a}=n.pocket,o=new Ut(new pa(a,a,Ta+1,40,1,!0,0,n.sweep).rotateX(Math.PI/2),t);o.position.set(s,r,(Ta-1)/2+.02),o.rotation.z=n.from+Math.PI/2;let l=new Ut(new _s(a-.02,a+.42,40,1,n.from,n.sweep),t);l.position.set(s,r,Ta+.02),e.add(o,l)}return e}function I0(i){let e=qn(i.cloth,.4),t=new Ut(new Li(e.x1-e.x0,e.y1-e.y0),new Pi({color:"#0a3a2c"}));return t.position.set((e.x0+e.x1)/2,(e.y0+e.y1)/2,i.floor-.05),t}var z1=2,V1=45,sf=12,Ho=class{constructor(e,t,n){this.stage=e;this.still=t;this.canvas=document.createElement("canvas"),this.renderer=new Ch({canvas:this.canvas,antialias:!0,alpha:!0,powerPreference:"high-performance"}),this.canvas.addEventListener("webglcontextlost",a=>{a.preventDefault(),n()});let{renderer:s,scene:r}=this;s.setClearColor(0,0),s.toneMapping=Po,s.toneMappingExposure=.95,s.shadowMap.enabled=!0,s.autoClear=!1,r.add(new To("#fff6e8","#3a8a6a",1.75)),this.lamp(),r.add(C0(e),P0(e)),e.table||r.add(I0(e)),this.solid=new Lh(e),this.halos=new Nh(e),r.add(this.solid.group,this.halos.group);for(let a of e.runs){let o=new Dh(e,a.index);this.ghostBalls.push(o),r.add(o.mesh)}this.eye=new Fh(e.sight,e.floor,t)}stage;still;canvas;renderer;scene=new ao;camera=new zn(26,1);eye;solid;halos;ghostBalls=[];trails=new Map;rings=new Map;base=new Gn;light=new Co("#fff1dc",2.7);width=1;height=1;slow=0;last=0;drawn=null;look(e){this.eye.look(e.camera==="free"?"free":"above")}close(e){this.eye.close(e)}orbit(e,t){this.eye.orbit(-3*e,-2.4*t)}zoom(e){this.eye.zoom(e)}pan(e,t){this.eye.pan(e,t,this.camera)}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t);let n=this.slow>=sf?1:z1;this.renderer.setPixelRatio(Math.min(n,window.devicePixelRatio||1)),this.renderer.setSize(this.width,this.height,!1)}draw(e,t,n){let{renderer:s,camera:r,eye:a}=this,o=performance.now();this.watch(o),this.drawn={frame:e,choice:t},s.setScissorTest(!1),s.clear(),s.setScissorTest(!0);let l=!1,c=Ps(t),h=this.cells(c.length);return c.forEach((u,d)=>{let{x:f,y:p,width:v,height:m}=h[d];r.aspect=v/m,l=a.place(r,o)||l,this.arrange(e,t,u,n);let g=this.height-p-m;s.setViewport(f,g,v,m),s.setScissor(f,g,v,m),s.render(this.scene,r)}),l}pick(e,t){if(!this.drawn)return-1;let{frame:n,choice:s}=this.drawn,r=Ps(s),a=this.cells(r.length),o=nl(a,e,t);if(o<0)return-1;let{x:l,y:c,width:h,height:u}=a[o];this.camera.aspect=h/u,this.eye.place(this.camera,performance.now());let d=n.scatters[r[o]],f=new W,p={ball:-1,distance:18};for(let v=0;v<d.present.length;v+=1){f.fromArray(d.positions,3*v).project(this.camera);let m=Math.hypot(l+(f.x+1)/2*h-e,c+(1-f.y)/2*u-t);d.present[v]&&m<p.distance&&(p={ball:v,distance:m})}return p.ball}dispose(){this.scene.traverse(e=>{if(e instanceof Ut){let t=e;t.geometry.dispose();for(let n of[t.material].flat())n.map?.dispose(),n.dispose()}}),this.renderer.dispose(),this.canvas.remove()}arrange(e,t,n,s){let r=e.scatters[n];this.solid.show(r,this.base,e.time,s),this.halos.show(r,t.called,t.ball);let a=el(t,n);this.ghostBalls.forEach((o,l)=>{o.mesh.visible=a.includes(l),o.mesh.visible&&o.show(e.scatters[l],r)});for(let o of this.trails.values())o.mesh.visible=!1;if(t.trails)for(let o of[n,...a]){let l=this.trailsOf(o,o!==n);l.mesh.visible=!0,l.show(e.time)}for(let o of this.rings.values())o.mesh.visible=!1;if(t.marks){let o=this.ringsOf(n);o.mesh.visible=!0,o.show(e.time,s)}}trailsOf(e,t){let n=`${e} ${t}`,s=this.trails.get(n);return s||(s=new Uh(this.stage,this.stage.runs[e],t),this.trails.set(n,s),this.scene.add(s.mesh)),s}ringsOf(e){let t=this.rings.get(e);return t||(t=new Oh(this.stage,this.stage.runs[e],this.still()),this.rings.set(e,t),this.scene.add(t.mesh)),t}cells(e){let{cells:t,lying:n}=tr(this.stage.sight,e,this.width,this.height);return this.lie(n),t}lie(e){this.eye.lying=e;let t=.3;e?this.base.setFromAxisAngle(new W(0,1,0),t).multiply(new Gn().setFromAxisAngle(new W(0,0,1),Math.PI/2)):this.base.setFromAxisAngle(new W(1,0,0),t)}lamp(){let{light:e,scene:t,stage:n}=this,{cloth:s}=n,[r,a]=[(s.x0+s.x1)/2,(s.y0+s.y1)/2],o=Math.hypot(s.x1-s.x0,s.y1-s.y0)/2+6;e.position.set(r-.25*o,a-.3*o,n.floor+1.6*o),e.target.position.set(r,a,n.floor),e.castShadow=!0,e.shadow.mapSize.set(2048,2048),e.shadow.radius=3,e.shadow.bias=-4e-4,e.shadow.normalBias=.04;let l=e.shadow.camera;[l.left,l.right,l.bottom,l.top]=[-o,o,-o,o],l.near=.2*o,l.far=3.2*o,t.add(e,e.target)}watch(e){let t=e-this.last;this.last=e,!(t>400||this.slow>=sf)&&(this.slow=t>V1?this.slow+1:Math.max(0,this.slow-1),this.slow>=sf&&(this.light.shadow.mapSize.set(1024,1024),this.light.shadow.map?.dispose(),this.light.shadow.map=null,this.resize(this.width,this.height)))}};var G1=9;function L0(i,e,t={}){let n=new sl(Math.max(0,...e.runs.map(l=>l.end))),s=fe("section",{class:"rp","aria-label":`Replay of ${e.scene.title}`},fe("p",{class:"rp-wait"},"Unpacking the replay …"));i.append(s),i.classList.add("rp-live");let r=null,a=!1,o=Nf(e).then(l=>{a||(r=new rf(s,Rf(e,l),n,t))}).catch(l=>{throw s.replaceChildren(fe("p",{class:"rp-wait",role:"alert"},`This replay cannot be shown: ${l instanceof Error?l.message:String(l)}`)),i.classList.remove("rp-live"),l});return o.catch(()=>{}),{ready:o,seek:l=>n.seek(l),play:()=>n.play(),pause:()=>n.pause(),time:()=>n.time,destroy:()=>{a=!0,n.stop(),r?.destroy(),s.remove(),i.classList.remove("rp-live")}}}var rf=class{constructor(e,t,n,s){this.element=e;this.stage=t;this.clock=n;let{data:r,runs:a}=t;this.frame=new cl(t);let o=Math.max(0,r.runs.findIndex(h=>h.reference)),l=r.balls.findIndex(h=>h.id==="cue");this.choice={camera:"above",solid:o,shown:a.map(()=>!0),apart:!1,trails:!0,marks:!0,ball:Math.max(0,l),called:[]},this.view=s.flat?null:this.world(),this.solidView=this.view!==null,this.view??=new Is(t,this.still),this.solidView||(this.choice.camera="flat"),this.controls=new ll(t,n,this,this.solidView),this.legend=new ul(t,this),this.readout=new Rl(t),this.plots=new Cl(t,this,s.growing??!1);let c=Of();this.picture.setAttribute("aria-label",`The table of ${r.scene.title}; the same in numbers under “Where the balls are now”`),this.picture.append(this.view.canvas,this.captions),e.replaceChildren(this.picture,this.controls.element,this.banner,this.status,this.legend.element,this.plots.element,this.readout.element,c),Uf(this.picture,{view:()=>this.view,again:this.ask,choose:h=>this.follow(h)}),Bf(e,{actions:this,view:()=>this.view,end:()=>t.end,camera:()=>this.choice.camera,nextCamera:()=>this.nextCamera(),toggleTrails:()=>this.trails(!this.choice.trails),again:this.ask,keys:c}),this.sizes=new ResizeObserver(()=>this.resize()),this.sizes.observe(e),n.listen(this.tick),this.resize(),this.view.look(this.choice),this.changed(),this.controls.mark(this.events()),this.tick(),s.autoplay&&!this.calm.matches&&n.play()}element;stage;clock;frame;choice;controls;legend;readout;plots;picture=fe("div",{class:"rp-picture",tabindex:0,role:"group"});captions=fe("div",{class:"rp-captions"});banner=fe("p",{class:"rp-banner",hidden:!0});status=fe("p",{class:"rp-status",role:"status"});sizes;calm=matchMedia("(prefers-reduced-motion: reduce)");view=null;called=-1;asked=0;solidView=!0;destroy(){cancelAnimationFrame(this.asked),this.sizes.disconnect(),this.plots.destroy(),this.view?.dispose(),this.view=null}toggle(){this.clock.playing?(this.clock.pause(),this.speak(this.where())):(this.clock.play(),this.speak("plays"))}seek(e){this.call(-1),this.clock.seek(e)}nudge(e){this.seek(this.clock.time+e*this.stage.end),this.clock.playing||this.speak(this.where())}event(e){this.clock.pause(),this.call(-1);let t=this.events(),n=Ua(t,this.clock.time);if(e===1)this.clock.seek(n<t.length?t[n].at:this.stage.end);else{let s=n-1;for(;s>=0&&t[s].at>=this.clock.time;)s-=1;this.clock.seek(s>=0?t[s].at:0)}this.speak(this.where())}parting(e){let{partings:t,balls:n}=this.stage.data;if(t.length===0){this.speak("no collision order differs");return}this.clock.pause();let s=e??(this.called+1)%t.length,r=t[s];for(let a of r.runs)a<this.choice.shown.length&&(this.choice.shown[a]=!0);this.clock.seek(Math.fround(r.time)),this.call(s),this.choice.called=r.balls.map(a=>n.findIndex(o=>o.id===a)).filter(a=>a>=0),this.view?.close(this.around(this.choice.called)),this.changed(),this.speak(`${Tn(r.time,this.stage.end)} ${this.stage.data.scene.time_unit}: ${r.words}`)}rate(e){this.clock.rate=e}faster(e){let t=Lr.indexOf(this.clock.rate)+e;this.rate(Lr[Math.min(Lr.length-1,Math.max(0,t))]),this.speak(`speed ${this.clock.rate}`)}look(e){let t=e==="flat";t!==(this.choice.camera==="flat")&&this.swap(t?new Is(this.stage,this.still):this.world()),this.choice.camera=this.view instanceof Is?"flat":e,this.view?.look(this.choice),this.changed()}apart(e){this.choice.apart=e,this.changed()}trails(e){this.choice.trails=e,this.changed()}marks(e){this.choice.marks=e,this.changed()}show(e,t){this.choice.shown[e]=t,this.changed()}solid(e){this.choice.shown[e]=!0,this.choice.solid=e,this.controls.mark(this.events()),this.changed(),this.tick()}follow(e){this.choice.ball=e,this.changed()}nextCamera(){let e=this.solidView?["above","free","flat"]:["flat"];this.look(e[(e.indexOf(this.choice.camera)+1)%e.length])}still=()=>this.calm.matches;world(){try{return new Ho(this.stage,this.still,()=>this.lost())}catch{return null}}lost(){let e=this.view;if(!(e instanceof Ho))return;let{camera:t}=this.choice;e.canvas.addEventListener("webglcontextrestored",()=>{this.view instanceof Is&&this.choice.camera==="flat"&&(e.dispose(),this.look(t))}),this.choice.camera="flat",this.swap(new Is(this.stage,this.still),!1),this.changed(),this.speak("the graphics were lost: the table is drawn flat")}swap(e,t=!0){if(!e||!this.view)return;let n=this.view;n.canvas.replaceWith(e.canvas),t&&n.dispose(),this.view=e,this.resize()}events(){return this.stage.runs[this.choice.solid]?.events??[]}where(){let{clock:e,stage:t}=this,n=this.events(),s=Ua(n,e.time),r=[];for(let o=s-1;o>=0&&n[o].at===e.time;o-=1)r.unshift(ol(n[o]));let a=`${Tn(e.time,t.end)} ${t.data.scene.time_unit}`;return r.length>0?`${a}, event ${s} of ${n.length}: ${r.join("; ")}`:`${a}, ${s} of ${n.length} events`}speak(e){di(this.status,e)}call(e){this.called=e;let t=e>=0?this.stage.data.partings[e]:void 0;if(this.banner.hidden=t===void 0,t){let{data:n,end:s}=this.stage,r=t.runs.map(a=>fe("span",{class:"rp-who"},dl(a),n.runs[a]?.label??""));this.banner.replaceChildren(...r,fe("b",{},`part at ${Tn(t.time,s)} ${n.scene.time_unit}. `),t.words)}else this.choice.called.length>0&&(this.choice.called=[],this.view?.close(null),this.ask());this.element.dataset.parting=String(e)}around(e){let{choice:t,frame:n}=this;n.go(this.clock.time);let s={x0:1/0,y0:1/0,x1:-1/0,y1:-1/0};for(let r of n.scatters.filter(({run:a})=>t.shown[a.index]))for(let a of e){let[o,l]=[r.positions[3*a],r.positions[3*a+1]];s.x0=Math.min(s.x0,o),s.x1=Math.max(s.x1,o),s.y0=Math.min(s.y0,l),s.y1=Math.max(s.y1,l)}return s.x1>=s.x0&&s.y1>=s.y0?qn(s,G1):null}tick=()=>{let{clock:e,element:t,stage:n}=this,s=this.called>=0?n.data.partings[this.called]:void 0;s&&Math.abs(e.time-s.time)>.8*e.rate*e.base&&this.call(-1),t.dataset.time=String(e.time),t.dataset.playing=String(e.playing),this.controls.tell(this.events()),this.plots.go(e.time,e.playing),this.ask(),!e.playing&&e.time>=n.end&&n.end>0&&this.speak(`the end, ${this.where()}`)};changed(){let{choice:e,stage:t}=this;this.controls.choose(e),this.legend.choose(e),this.plots.choose(e),this.element.dataset.view=e.camera,this.caption(),this.plots.go(this.clock.time,this.clock.playing),this.element.dataset.solid=t.data.runs[e.solid]?.label??"",this.ask()}caption(){let{choice:e,stage:t}=this,n=Ps(e);if(this.captions.hidden=n.length<2,n.length<2)return;let{width:s,height:r}=this.picture.getBoundingClientRect(),{cells:a}=tr(t.sight,n.length,s,r);this.captions.replaceChildren(...n.map((o,l)=>{let c=fe("span",{},dl(o),t.data.runs[o].label);return c.style.left=`${a[l].x}px`,c.style.top=`${a[l].y}px`,c}))}resize(){let{stage:e,picture:t,view:n}=this,s=this.element.clientWidth;if(s<=0||!n)return;let{sight:r}=e,a=[r.x1-r.x0,r.y1-r.y0],[o,l]=[Math.max(...a),Math.min(...a)],c=s<560,h=c?s*o/l:s*l/o,u=Math.round(Math.min(Math.max(h,260),Math.max(300,(c?.56:.64)*window.innerHeight)));t.style.height=`${u}px`,n.resize(s,u),this.caption(),this.draw()}ask=()=>{this.asked===0&&(this.asked=requestAnimationFrame(()=>{this.asked=0,this.draw()}))};draw(){this.view&&(this.frame.go(this.clock.time),this.readout.tell(this.frame,this.choice.solid,this.clock.playing),this.element.dataset.drawn=String(this.clock.time),this.view.draw(this.frame,this.choice,this.clock.rate*this.clock.base)&&this.ask())}};var qo=class extends Error{constructor(t){super(t.map(n=>n.message).join("; "));this.problems=t}problems},D0=200*1024,H1=350;function Ms(i){let e=document.querySelector(i);if(!e)throw new Error(`the page has no ${i}`);return e}var af=class{form=Ms("#shot");tools=Ms("#tools");status=Ms("#status");stage=Ms("#replay");answer=Ms("#answer");name=Ms("#name");stop=rs("Stop the computation",["Stop"],()=>this.running?.abort());copy=rs("Copy a link that carries the whole scene",["Copy link"],()=>{this.copyLink()});save=rs("Save as a scene file",["Save scene"],()=>this.saveFile());file=fe("input",{type:"file",accept:".toml,text/plain",class:"sr",id:"open-file"});calm=matchMedia("(prefers-reduced-motion: reduce)");base="";link=null;running=null;drawing=null;pause=0;replay=null;constructor(){this.form.noValidate=!0,this.link=document.querySelector("#link")?.getAttribute("href")??null,this.stop.hidden=!0;let e=fe("label",{class:"file",for:"open-file"},"Open scene …",this.file);this.tools.replaceChildren(this.copy,this.save,e),this.filledIn(),this.form.addEventListener("submit",t=>{t.preventDefault(),this.start(t.submitter)}),this.form.addEventListener("input",t=>this.typed(t.target)),Ms("#picker").addEventListener("submit",t=>{t.preventDefault();let n=Ms("#scene").value;this.load(()=>Xo(`/scenes/${encodeURIComponent(n)}`))}),this.file.addEventListener("change",()=>{let[t]=this.file.files??[];t&&this.openFile(t),this.file.value=""}),this.dropping()}get text(){return Ms("#f-scene")}filledIn(){this.base=this.text.value,this.form.querySelector(".go")?.append(this.stop),this.linked()}linked(){this.copy.disabled=this.link===null,this.copy.title=this.link===null?"This scene is too long for a link: save it as a file":"Copy a link that carries the whole scene"}fields(e){let t={},n=new FormData(this.form);for(let s of new Set(n.keys())){let r=n.getAll(s).filter(o=>typeof o=="string"),a=s==="engine"||s==="more-engines"||s.startsWith("dt.");s==="engine"?t[s]=r:s!=="scene"&&s!=="run"&&(e==="form"||a)&&(t[s]=r[r.length-1]??"")}return{scene:e==="form"?this.base:this.text.value,fields:t}}unreadable(){return[...this.form.querySelectorAll("input[type=number]")].filter(t=>t.validity.badInput&&t.offsetParent!==null).map(t=>({field:t.name,line:null,column:null,message:`${t.labels?.[0]?.firstChild?.textContent?.trim()??t.name} must be a number`,help:"such as 0.2 or 1e-3"}))}async start(e){let t=e instanceof HTMLButtonElement&&e.value==="file",n=t?[]:this.unreadable();if(n.length>0){this.wrong(n);return}clearTimeout(this.pause),this.drawing?.abort(),this.running?.abort();let s=new AbortController;this.running=s,this.busy(!0);let r=performance.now();try{let a=this.fields(t?"file":"form");await Xo("/scene",a,s.signal);let o=await Xo("/shot",a,s.signal);this.shown(o,t,(performance.now()-r)/1e3)}catch(a){this.running===s&&this.failed(a,"The computation was stopped.")}finally{this.running===s&&(this.running=null,this.busy(!1))}}busy(e){this.form.querySelector(".start")?.setAttribute("aria-busy",String(e)),this.stop.hidden=!e,e&&this.say("Running …")}shown(e,t,n){this.correct(),t?this.fill(e):this.take(e);let s=e.notice?`<p class="notice-line">${W1(e.notice)}</p>`:"";this.answer.innerHTML=s+e.html,this.replay?.destroy(),this.replay=null,this.stage.classList.remove("stale");let r=this.answer.querySelector(".lead")?.textContent??"";this.say(`All engines answered in ${n.toFixed(2)} s. ${e.no_replay?`There is no replay: ${e.no_replay}.`:""}`,r),e.replay&&(this.replay=L0(this.stage,e.replay,{growing:!0,autoplay:!0})),this.stage.getBoundingClientRect().top>.7*window.innerHeight&&this.stage.scrollIntoView({behavior:this.calm.matches?"auto":"smooth",block:"start"})}take(e){this.text.value=e.toml,this.link=e.link,di(this.name,e.name),document.title=`${e.name} · carom play`,e.link&&history.replaceState(null,"",e.link),this.linked()}fill(e){let t=[...this.form.querySelectorAll("details[open]")].map(s=>s.id),n=document.activeElement?.id;this.form.innerHTML=e.form;for(let s of t)document.getElementById(s)?.setAttribute("open","");this.filledIn(),this.take(e),n&&this.form.contains(document.getElementById(n))&&document.getElementById(n)?.focus({preventScroll:!0})}typed(e){clearTimeout(this.pause);let t=e===this.text;this.pause=window.setTimeout(()=>{this.draw(t)},H1)}async draw(e){let t=e?[]:this.unreadable();if(t.length>0){this.wrong(t,!1);return}this.drawing?.abort();let n=new AbortController;this.drawing=n;try{let s=await Xo("/scene",this.fields(e?"file":"form"),n.signal);if(this.correct(),e){let{selectionStart:r,selectionEnd:a,scrollTop:o}=this.text,l=this.text.value;this.fill(s),this.text.value=l,this.base=l,this.text.setSelectionRange(r,a),this.text.scrollTop=o}else this.take(s);this.outdated(s)}catch(s){s instanceof qo?this.wrong(s.problems,!1):n.signal.aborted||this.failed(s,"")}}outdated(e){this.replay?(this.stage.classList.add("stale"),this.answer.classList.add("stale"),this.say("The inputs have changed since this ran.")):(this.stage.innerHTML=e.picture,this.say(""))}async load(e){this.running?.abort();try{let t=await e();this.correct(),this.fill(t),this.replay?.destroy(),this.replay=null,this.answer.replaceChildren(),this.stage.classList.remove("stale"),this.stage.innerHTML=t.picture,this.say(`Opened ${t.name}.`)}catch(t){this.failed(t,"")}}async openFile(e){if(e.size>D0){this.wrong([{field:null,line:null,column:null,message:`${e.name} has ${e.size} bytes; ${D0} are the most`,help:"carom compare takes a file of any size"}]);return}let t=await e.text();await this.load(()=>Xo("/scene",{scene:t}))}dropping(){let{body:e}=document,t=n=>n.dataTransfer?.types.includes("Files")??!1;addEventListener("dragover",n=>{t(n)&&(n.preventDefault(),e.classList.add("dropping"))}),addEventListener("dragleave",n=>{n.relatedTarget===null&&e.classList.remove("dropping")}),addEventListener("drop",n=>{e.classList.remove("dropping");let s=n.dataTransfer?.files[0];s&&(n.preventDefault(),this.openFile(s))})}async copyLink(){if(this.link===null)return;let e=location.origin+this.link;try{await navigator.clipboard.writeText(e),this.say("The link is copied. It works wherever carom play runs on this port.")}catch{history.replaceState(null,"",this.link),this.say("The browser does not let a page copy: the link is in its address bar.")}}saveFile(){let e=this.name.textContent||"scene",t=`data:application/toml;charset=utf-8,${encodeURIComponent(this.text.value)}`;fe("a",{href:t,download:`${e}.toml`}).click(),this.say(`Saved as ${e}.toml. carom compare ${e}.toml prints the same numbers.`)}failed(e,t){e instanceof qo?this.wrong(e.problems):e instanceof DOMException&&e.name==="AbortError"?this.say(t):this.say("carom play does not answer: it may have been ended. Start it again with carom play.","",!0)}correct(){this.form.querySelectorAll(".error").forEach(e=>e.remove()),this.form.querySelector(".errors")?.replaceChildren();for(let e of this.form.querySelectorAll("[aria-invalid]"))e.removeAttribute("aria-invalid"),e.setAttribute("aria-describedby",`hint-${e.id}`);this.stage.classList.remove("stale"),this.answer.classList.remove("stale"),this.status.classList.remove("wrong")}wrong(e,t=!0){this.correct();let n=this.form.querySelector(".errors"),s=null;for(let o of e){let l=o.field===null?null:this.control(o.field);if(!l){let d=o.line===null?"":`${o.line}:${o.column}: `;n?.append(fe("li",{},d,...Wo(o.message),". ",fe("span",{class:"help"},...Wo(o.help))));continue}let c=o.field==="scene"&&o.line!==null?`line ${o.line}: `:"",h=`error-${l.id}`,u=fe("p",{class:"error"},c,...Wo(o.message),". ",fe("span",{class:"help"},...Wo(o.help)));document.getElementById(h)||(u.id=h),l.setAttribute("aria-invalid","true"),l.setAttribute("aria-describedby",`${h} hint-${l.id}`),l.closest(".field, .tick")?.append(u),l.closest("details")?.setAttribute("open",""),s??=l}let[r,a]=[e.length,e.length===1?"One thing is":`${e.length} things are`];this.say(r>0?`${a} wrong: ${e[0].message}.`:"","",!0),t&&s?.focus()}control(e){return this.form.querySelectorAll(`[name="${CSS.escape(e)}"]:not([type=hidden])`)[0]??null}say(e,t="",n=!1){this.status.replaceChildren(...Wo(e),...t?[fe("span",{class:"sr"},` ${t}`)]:[]),this.status.classList.toggle("wrong",n)}};function W1(i){return fe("p",{},i).innerHTML}function Wo(i){return i.split("`").map((e,t)=>t%2===1?fe("code",{},e):e)}async function Xo(i,e,t){let n=e===void 0?{}:{method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e)},s=await fetch(i,{...n,signal:t??null}),r=await s.json();if(r.errors||!s.ok)throw new qo(r.errors??[{field:null,line:null,column:null,message:`the server answered ${s.status}`,help:""}]);return r}new af;})();
