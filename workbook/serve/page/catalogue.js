// What comes with motionbook: families of laws with their shapes, motors and reducers with their figures.
import { signal } from "./html.js";

export const laws = signal([]);
export const products = signal({ motor: [], reducer: [] });
