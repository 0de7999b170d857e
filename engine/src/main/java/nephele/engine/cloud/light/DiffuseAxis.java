package nephele.engine.cloud.light;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The axis along which diffuse light flows from where there is much to where there is little: through a layer from its lit
 * side to the other, through a ball along the beam.
 */
public final class DiffuseAxis {
    /** Sine of the sun's elevation below which the flow through a layer turns around gradually. */
    private static final double TURNING_SINE = 0.1;

    private DiffuseAxis() {}

    /**
     * Returns the axis in a layer.
     *
     * @param towardsSun unit
     */
    public static Vec3 ofLayer(Vec3 towardsSun) {
        return new Vec3(0, -Math.max(-1, Math.min(1, towardsSun.y() / TURNING_SINE)), 0);
    }

    /**
     * Returns the axis in a finite cloud: that of a layer if it is flat, that of a ball if it is not, between them a mixture,
     * which is shorter than 1.
     *
     * @param towardsSun unit
     */
    public static Vec3 of(Aabb extent, Vec3 towardsSun) {
        double narrowest = Math.min(extent.maxX() - extent.minX(), extent.maxZ() - extent.minZ());
        double flatness = Math.max(0, 1 - 2 * (extent.maxY() - extent.minY()) / narrowest);
        return towardsSun.scaled(flatness - 1).addScaled(flatness, ofLayer(towardsSun));
    }
}
