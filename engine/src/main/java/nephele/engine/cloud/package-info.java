/**
 * Clouds as physics: {@link nephele.engine.cloud.ExtinctionField} is the extinction per metre at each point, from which
 * every technique derives optical depth; {@link nephele.engine.cloud.PhaseFunction} is the distribution of
 * scattered directions.
 */
package nephele.engine.cloud;
