package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Slot;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidBatch;

/**
 * The layers of a terrain as its shader reads them.
 *
 * @param surfaces the material of each layer; a colour layer of −1 for one without a picture in the array
 * @param kind the array of the first picture, and whether all layers are Lambertian
 * @param limits as {@link TerrainLayers#limits}
 * @param origins the pictures' coordinates at the terrain's origin, two numbers for each layer
 */
record GroundLook(List<Surface> surfaces, SolidBatch.Kind kind, double[] limits, double[] origins) {
    static GroundLook of(StaticShape.HeightGrid grid, SceneMaterials materials) {
        TerrainLayers layers = TerrainLayers.of(grid.said());
        List<Surface> all = new ArrayList<>();
        for (int i = 0; i < layers.count(); i++) {
            all.add(materials.surfaces().get(materials.indexOf(layers.material(i))));
        }
        double[] limits = layers.limits();
        if (all.isEmpty()) {
            all.add(materials.surfaces().get(0));
            limits = new double[] {-3e7, -2e7, 2e7, 3e7, 2, 3, -3, -2};
        }
        int array = all.stream()
                .mapToInt(surface -> surface.colour().array())
                .filter(found -> found >= 0)
                .findFirst()
                .orElse(-1);
        boolean isLambert = all.stream().allMatch(surface -> surface.material().lambert());
        List<Surface> drawn =
                all.stream().map(surface -> inArray(surface, array)).toList();
        return new GroundLook(
                drawn,
                new SolidBatch.Kind(isLambert, array, -1, 0),
                limits,
                origins(all, grid.field().origin()));
    }

    private static Surface inArray(Surface surface, int array) {
        boolean isThere = array >= 0 && surface.colour().array() == array;
        return isThere ? surface : new Surface(surface.material(), new Slot(-1, -1), Slot.NONE);
    }

    /** Whole repeats are left out, so that the numbers stay small far from the world's origin. */
    private static double[] origins(List<Surface> surfaces, Vec3 origin) {
        double[] origins = new double[2 * surfaces.size()];
        for (int i = 0; i < surfaces.size(); i++) {
            double metres = surfaces.get(i).material().textureMetres();
            origins[2 * i] = fraction(origin.x() / metres);
            origins[2 * i + 1] = fraction(origin.z() / metres);
        }
        return origins;
    }

    private static double fraction(double number) {
        return number - Math.floor(number);
    }
}
