package nephele.editor.proving;

/**
 * The fineness of a heat map and its shooter.
 *
 * @param spacingMetres side of its cells; coarser where the level would have more than {@code mostCells}
 * @param yawRadians direction that the shooter faces over floors and under ceilings; 0 looks along −z, positive to the
 *     left
 */
public record HeatSettings(double spacingMetres, double yawRadians, int mostCells) {
    /** Cells of a quarter of a metre, seen by a shooter who faces −z. */
    public static final HeatSettings DEFAULT = new HeatSettings(0.25, 0, 40_000);
}
