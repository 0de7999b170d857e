package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidBatch;

/**
 * The layers of a terrain as its shader reads them.
 *
 * @param surfaces the material of each layer; picture −1 where it has none
 * @param kind whether there are pictures, and whether all layers are Lambertian
 * @param limits as {@link TerrainLayers#limits}
 * @param origins the terrain's origin in repeats of the pictures of each layer
 */
record GroundLook(
        List<Surface> surfaces,
        SolidBatch.Kind kind,
        LayerPictures colours,
        LayerPictures normals,
        double[] limits,
        List<Vec3> origins) {
    static GroundLook of(StaticShape.HeightGrid grid, SceneMaterials materials) {
        TerrainLayers layers = TerrainLayers.of(grid.authored());
        List<Surface> all = new ArrayList<>();
        for (int i = 0; i < layers.count(); i++) {
            all.add(materials.surfaces().get(materials.indexOf(layers.material(i))));
        }
        double[] limits = layers.limits();
        if (all.isEmpty()) {
            all.add(materials.surfaces().get(0));
            limits = new double[] {-3e7, -2e7, 2e7, 3e7, 2, 3, -3, -2};
        }
        LayerPictures colours =
                LayerPictures.of(all.stream().map(Surface::colour).toList(), materials.colourArrays());
        LayerPictures normals =
                LayerPictures.of(all.stream().map(Surface::normal).toList(), materials.normalArrays());
        List<Surface> drawn = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            drawn.add(new Surface(all.get(i).material(), colours.slot(i), normals.slot(i)));
        }
        boolean isLambert = all.stream().allMatch(surface -> surface.material().lambert());
        return new GroundLook(
                drawn,
                new SolidBatch.Kind(isLambert, colours.array(), normals.array(), 0),
                colours,
                normals,
                limits,
                all.stream()
                        .map(surface -> repeats(
                                grid.field().origin(), surface.material().textureMetres()))
                        .toList());
    }

    /** Returns the look with the colours of all layers in one picture, without normal maps. */
    GroundLook baked() {
        LayerPictures colour = new LayerPictures(LayerPictures.OWN, List.of(), List.of());
        LayerPictures none = new LayerPictures(-1, List.of(), List.of());
        return new GroundLook(
                surfaces, new SolidBatch.Kind(kind.lambert(), colour.array(), -1, 0), colour, none, limits, origins);
    }

    /** Whole repeats are left out, so that the numbers stay small far from the world's origin. */
    private static Vec3 repeats(Vec3 origin, double metres) {
        return new Vec3(fraction(origin.x() / metres), fraction(origin.y() / metres), fraction(origin.z() / metres));
    }

    private static double fraction(double number) {
        return number - Math.floor(number);
    }
}
