/** Makes the extinction field of a level's cloud: {@link nephele.engine.cloud.field.CloudFields}, one class a density. */
package nephele.engine.cloud.field;
