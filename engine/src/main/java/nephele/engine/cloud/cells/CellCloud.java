package nephele.engine.cloud.cells;

import nephele.engine.cloud.light.CloudLight;

/** A cloud as it is marched: what each point of its box holds of extinction and light. */
public record CellCloud(DensityCells density, LightCells light, CloudLight physics) {}
