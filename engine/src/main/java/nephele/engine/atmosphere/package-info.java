/** Scattering of sunlight in the air around a round planet. */
package nephele.engine.atmosphere;
