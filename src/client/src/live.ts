// Entry of the live page.
import "./live.css";
import "./replay.css";
export { mount } from "./component.ts";
