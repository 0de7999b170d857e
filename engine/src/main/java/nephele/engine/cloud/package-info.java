/**
 * Clouds as physics: {@link nephele.engine.cloud.ExtinctionField} gives the extinction per metre of a level's cloud,
 * from which every technique derives optical depth. {@link nephele.engine.cloud.VolumeTracer} is the exact twin: it
 * computes radiance without bias, by random walks.
 */
package nephele.engine.cloud;
