package nephele.engine.cloud.cells;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A cloud as it is marched: boxes of cells of extinction and light. A finite cloud has one box. A layer has several of
 * the same heights, each {@value #WIDENING} times as wide as the one before; which one serves a place depends on its
 * distance from a focus, and near the end of each box's reach the next one takes over gradually.
 *
 * @param density from the narrowest box on, of one scale
 * @param light of the same boxes
 * @param planetRadiusMetres of the planet around which a layer bends; infinite for a flat one
 * @param reachMetres distance from the focus up to which the narrowest box serves; infinite for a finite cloud
 */
public record CellStack(
        List<DensityCells> density,
        List<LightCells> light,
        CloudLight physics,
        double planetRadiusMetres,
        double reachMetres) {
    /** Widths of successive boxes. */
    public static final int WIDENING = 3;

    public CellStack {
        density = List.copyOf(density);
        light = List.copyOf(light);
    }

    /** Returns a finite cloud. */
    public static CellStack finite(DensityCells density, LightCells light, CloudLight physics) {
        return new CellStack(
                List.of(density), List.of(light), physics, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** Returns a layer in the boxes of a {@link LayerGrid}. */
    public static CellStack layer(
            List<DensityCells> density, List<LightCells> light, CloudLight physics, double planetRadiusMetres) {
        return new CellStack(
                density,
                light,
                physics,
                planetRadiusMetres,
                LayerGrid.REACH * density.get(0).cells().sizeX());
    }

    /**
     * Returns the axis along which diffuse light flows, see {@link CloudLight#diffuseAxis}.
     *
     * @param towardsSun unit
     */
    public Vec3 diffuseAxis(Vec3 towardsSun) {
        return diffuseAxis(isLayer(), narrowest(), towardsSun);
    }

    static Vec3 diffuseAxis(boolean isLayer, CellBox cells, Vec3 towardsSun) {
        return isLayer ? CloudLight.diffuseAxisOfLayer(towardsSun) : CloudLight.diffuseAxis(cells.box(), towardsSun);
    }

    /** Returns the least optical depth from a place to the outside along an axis; 0 outside of the boxes. */
    public double leastDepth(Vec3 place) {
        Aabb box = density.get(density.size() - 1).cells().box();
        if (!box.contains(place.x(), place.y(), place.z())) {
            return 0;
        }
        var depths = new StackDepths(density, isLayer());
        int level = depths.level(place.x(), place.z(), narrowest().sizeX());
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 6; axis++) {
            int sign = axis < 3 ? 1 : -1;
            double depth = depths.nearBy(
                    level,
                    place.x(),
                    place.y(),
                    place.z(),
                    axis % 3 == 0 ? sign : 0,
                    axis % 3 == 1 ? sign : 0,
                    axis % 3 == 2 ? sign : 0);
            least = Math.min(least, depth);
        }
        return least;
    }

    /** Returns the box of the narrowest cells. */
    public CellBox narrowest() {
        return density.get(0).cells();
    }

    public int levels() {
        return density.size();
    }

    /** Returns true if the cells end at no side. */
    public boolean isLayer() {
        return reachMetres < Double.POSITIVE_INFINITY;
    }

    /** Returns the extinction that density 1 stands for. */
    public double greatestPerMetre() {
        return density.get(0).greatestPerMetre();
    }

    /** Returns the extinction that density 1 stands for when the cloud's weather has come wholly. */
    public double wholePerMetre() {
        return density.get(0).wholePerMetre();
    }

    /**
     * Puts a slice of a box at this time and a later one as texels: density now, distance divided by {@link
     * DensityCells#FARTHEST}, what absorption leaves, density later.
     */
    public void putDensity(CellStack later, int box, int k, ByteBuffer texels) {
        DensityCells before = density.get(box);
        DensityCells after = later.density.get(box);
        CellBox cells = before.cells();
        LightCells lightOfBox = light.get(box);
        boolean absorbs = physics.optics().albedo() < 1;
        var lit = new CellPlace(lightOfBox.cells());
        float[] values = lightOfBox.values();
        for (int j = 0; j < cells.ny(); j++) {
            for (int i = 0; i < cells.nx(); i++) {
                int at = cells.index(i, j, k);
                double left = 1;
                if (absorbs) {
                    lit.at(cells.centreX(i), cells.centreY(j), cells.centreZ(k));
                    left = lit.of(values, LightCells.VALUES, 3) + lit.of(values, LightCells.VALUES, 4);
                }
                int distance = Math.min(before.distances()[at], after.distances()[at]);
                texels.put((byte) Math.round(255 * before.densities()[at]))
                        .put((byte) (255 * distance / DensityCells.FARTHEST))
                        .put((byte) Math.round(255 * Math.min(1, left)))
                        .put((byte) Math.round(255 * after.densities()[at]));
            }
        }
    }
}
