package nephele.engine.scene.light;

import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.SampleRange;

/** Where heights in a rectangle can be seen: on it, and along directions that cross it. All is as seen from above. */
record SeenChange(double minX, double minZ, double maxX, double maxZ) {
    /** The smooth normal of a place depends on samples of so many cells around it. */
    private static final int NORMAL_CELLS = 2;

    static SeenChange of(HeightField field, SampleRange changed) {
        SampleRange reach = changed.grown(NORMAL_CELLS);
        return new SeenChange(
                field.x(reach.firstColumn()),
                field.z(reach.firstRow()),
                field.x(reach.lastColumn()),
                field.z(reach.lastRow()));
    }

    boolean isAt(double x, double z) {
        return x >= minX && x <= maxX && z >= minZ && z <= maxZ;
    }

    boolean isAlong(double x, double z, double towardsX, double towardsZ) {
        double toMinX = (minX - x) / towardsX;
        double toMaxX = (maxX - x) / towardsX;
        double toMinZ = (minZ - z) / towardsZ;
        double toMaxZ = (maxZ - z) / towardsZ;
        double enter = Math.max(Math.min(toMinX, toMaxX), Math.min(toMinZ, toMaxZ));
        double leave = Math.min(Math.max(toMinX, toMaxX), Math.max(toMinZ, toMaxZ));
        return leave >= Math.max(enter, 0);
    }
}
