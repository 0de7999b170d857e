/** The speed/accuracy report: what each knob of the engine costs, how wrong each of its settings is, and which to choose. */
package nephele.lab.trade;
