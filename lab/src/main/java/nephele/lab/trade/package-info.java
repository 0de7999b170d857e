/**
 * The speed/accuracy report: the cost of each parameter of the engine, the error of each of its settings, and
 * recommendations.
 */
package nephele.lab.trade;
