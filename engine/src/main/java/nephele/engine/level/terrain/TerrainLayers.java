package nephele.engine.level.terrain;

import java.util.List;
import nephele.engine.level.Terrain;

/**
 * The mixture of a terrain's layers at a height and a slope. The weight of a layer is the product of three factors:
 *
 * <ul>
 *   <li>the height's: 1 between its limits, falling to 0 over {@code blendMetres} around each, half of it on either side;
 *   <li>the least slope's and the steepest slope's: 1 on the allowed side, falling to 0 between {@link
 *       #SLOPE_BLEND_DEGREES} / 2 below and above the limit, in the cosine of the slope. Limits of 0° and 90° do not fade.
 * </ul>
 *
 * All fall as the polynomial t² (3 − 2t), so two layers that meet at a limit have a sum of 1 there. The weights are
 * divided by their sum. Where no layer has a weight, the first one counts. The shader of the terrain has the same lines.
 */
public final class TerrainLayers {
    /** The angle over which a limit of slope fades. */
    public static final double SLOPE_BLEND_DEGREES = 6;

    /** Numbers of {@link #limits} for each layer. */
    public static final int LIMITS = 8;

    private final List<Terrain.Layer> layers;
    private final double[] limits;

    private TerrainLayers(List<Terrain.Layer> layers) {
        this.layers = List.copyOf(layers);
        limits = new double[LIMITS * layers.size()];
        for (int i = 0; i < layers.size(); i++) {
            write(layers.get(i), LIMITS * i);
        }
    }

    /** Returns the layers of a terrain. */
    public static TerrainLayers of(Terrain authored) {
        return new TerrainLayers(authored.layers());
    }

    private void write(Terrain.Layer layer, int at) {
        double half = layer.blendMetres() / 2;
        limits[at] = layer.fromMetres() - half;
        limits[at + 1] = layer.fromMetres() + half;
        limits[at + 2] = layer.toMetres() - half;
        limits[at + 3] = layer.toMetres() + half;
        boolean isOfAllGentle = layer.minSlopeDegrees() == 0;
        limits[at + 4] = isOfAllGentle ? 2 : cosine(layer.minSlopeDegrees() + SLOPE_BLEND_DEGREES / 2);
        limits[at + 5] = isOfAllGentle ? 3 : cosine(layer.minSlopeDegrees() - SLOPE_BLEND_DEGREES / 2);
        boolean isOfAllSteep = layer.maxSlopeDegrees() == 90;
        limits[at + 6] = isOfAllSteep ? -3 : cosine(layer.maxSlopeDegrees() + SLOPE_BLEND_DEGREES / 2);
        limits[at + 7] = isOfAllSteep ? -2 : cosine(layer.maxSlopeDegrees() - SLOPE_BLEND_DEGREES / 2);
    }

    private static double cosine(double degrees) {
        return Math.cos(Math.toRadians(degrees));
    }

    /** Returns the number of layers. */
    public int count() {
        return layers.size();
    }

    /** Returns the material of a layer. */
    public String material(int layer) {
        return layers.get(layer).material();
    }

    /**
     * Returns the limits of all layers, {@link #LIMITS} numbers each: the height at which the weight begins to rise and at
     * which it is 1, at which it begins to fall and at which it is 0; then the same four for the upward component of the
     * normal, where the first two are those of the least slope, at which the weight falls.
     */
    public double[] limits() {
        return limits.clone();
    }

    /**
     * Writes the weights of all layers; their sum is 1.
     *
     * @param height in metres above the terrain's centre
     * @param up the upward component of the unit normal, the cosine of the slope
     */
    public void weights(double height, double up, double[] weights) {
        double sum = 0;
        for (int i = 0; i < count(); i++) {
            weights[i] = weight(LIMITS * i, height, up);
            sum += weights[i];
        }
        for (int i = 0; i < count(); i++) {
            weights[i] = sum > 0 ? weights[i] / sum : i == 0 ? 1 : 0;
        }
    }

    private double weight(int at, double height, double up) {
        return rise(height, limits[at], limits[at + 1])
                * fall(height, limits[at + 2], limits[at + 3])
                * fall(up, limits[at + 4], limits[at + 5])
                * rise(up, limits[at + 6], limits[at + 7]);
    }

    private static double rise(double x, double zero, double one) {
        if (x >= one) {
            return 1;
        } else if (x <= zero) {
            return 0;
        }
        double t = (x - zero) / (one - zero);
        return t * t * (3 - 2 * t);
    }

    private static double fall(double x, double one, double zero) {
        return rise(-x, -zero, -one);
    }
}
