package nephele.engine.scene.probe;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import nephele.engine.asset.Picture;
import nephele.engine.level.Brush;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.scene.Scene;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.PictureArray;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.LightMapLookup;
import nephele.engine.scene.light.TerrainSky;
import nephele.engine.scene.light.bake.FaceFragment;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.LightSamples;
import nephele.engine.scene.light.bake.Occluders;
import nephele.engine.scene.light.bake.SkyVisibility;

/**
 * The baked light at points of the static geometry that rays hit, and what of it leaves them: times the mean reflectance
 * of the material, plus its emission, equal in all directions. Light of layers that are dimmed apart is kept apart: colours
 * are RGB of each name of {@link #names} in turn. For one thread.
 */
public final class LitSurfaces {
    /** What an insulator's specular lobe returns of equal light from all directions; as in {@code surface-light.glsl}. */
    private static final double SPECULAR_ALBEDO = 0.05;

    /** A texture's mean is that of at most so many pixels along each side. */
    private static final int MEAN_PIXELS = 64;

    private static final int RGB = LightSamples.CHANNELS;

    private final Occluders occluders;
    private final SceneMaterials materials;
    private final List<IndirectLight.Layer> layers;
    private final List<String> names;
    private final LightMapLayout layout;
    private final LightMapLookup lookup;
    private final List<List<List<FaceFragment>>> fragments;
    /** Places in the light map by solid, face and fragment; filled when a solid is first hit. */
    private final LightMapLookup.Spot[][][] spots;
    /** The place of a model's first vertex among those baked; models that were not baked have none and are black. */
    private final Map<PlacedModel, Integer> firstVertex = new IdentityHashMap<>();

    private final Map<StaticShape.HeightGrid, TerrainLayers> layersOf = new IdentityHashMap<>();
    /** Mean RGB reflectance by index of the material; filled on first use. */
    private final double[][] reflectances;

    private final double[] reflectance = new double[RGB];
    private final double[] emission = new double[RGB];

    /** Makes the surfaces of a scene that has baked light. */
    public LitSurfaces(Scene scene) {
        layers = scene.light().indirect().layers();
        names = Stream.concat(Stream.of(""), layers.stream().map(IndirectLight.Layer::name))
                .distinct()
                .toList();
        occluders = new Occluders(scene.statics().split(SkyVisibility.MODEL_EDGE_METRES));
        materials = scene.materials();
        layout = scene.light().layout();
        lookup = new LightMapLookup(scene.light().visibility(), scene.statics().solids());
        fragments = scene.cut().byBrush();
        spots = new LightMapLookup.Spot[fragments.size()][][];
        reflectances = new double[materials.surfaces().size()][];
        for (PlacedModel model : occluders.shapes().models().all()) {
            int first = 0;
            for (PlacedModel baked : scene.light().statics().models().all()) {
                int numbers = baked.triangles().positions().length;
                if (baked.authored().id().equals(model.authored().id())
                        && numbers == model.triangles().positions().length) {
                    firstVertex.put(model, first);
                }
                first += numbers / 3;
            }
        }
    }

    /** Returns the names of the layers, first the empty one, to which emission belongs. */
    public List<String> names() {
        return names;
    }

    /** Returns the geometry that rays hit; its models are split as for the bake. */
    public Occluders occluders() {
        return occluders;
    }

    /**
     * Writes the radiance that leaves a point.
     *
     * @param item that a ray has hit there
     * @param face of {@link Occluders#faceOf}; a solid has no light inside, where it is −1
     */
    public void leaving(int item, int face, Vec3 place, double[] rgb) {
        arriving(item, face, place, rgb);
        Arrays.fill(reflectance, 0);
        Arrays.fill(emission, 0);
        if (occluders.isSolid(item)) {
            if (face >= 0) {
                Brush solid = occluders.shapes().solids().get(item);
                addMaterial(1, solid.faces().get(face).material());
            }
        } else if (occluders.shapeOf(item) instanceof StaticShape.HeightGrid grid) {
            addLayers(grid, place);
        } else if (occluders.shapeOf(item) instanceof StaticShape.TriangleMesh mesh) {
            addMaterial(1, mesh.model().authored().material());
        }
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = rgb[i] * reflectance[i % RGB] + (i < RGB ? emission[i] : 0);
        }
    }

    /**
     * Writes the mean radiance that arrives at a point from all directions, of all layers together, RGB. Models that are drawn as impostors send and
     * hide nothing: the point may be within one.
     */
    public void around(Vec3 place, int rays, float[] out, int at) {
        double[][] directions = SkyProbes.evenly(rays);
        double[] from = {place.x(), place.y(), place.z()};
        double[] sum = new double[RGB];
        double[] rgb = new double[RGB * names.size()];
        RayHit hit = new RayHit();
        for (double[] d : directions) {
            Ray ray = new Ray(from[0], from[1], from[2], d[0], d[1], d[2]);
            ItemRayTest meets = (sight, item, limit) ->
                    isImpostor(item) ? Double.POSITIVE_INFINITY : occluders.hit(item, from, d, limit);
            if (occluders.nearest(ray, Double.MAX_VALUE, meets, hit)) {
                leaving(hit.item(), occluders.faceOf(hit.item(), from, d), ray.at(hit.distance()), rgb);
                for (int i = 0; i < rgb.length; i++) {
                    sum[i % RGB] += rgb[i] / rays;
                }
            }
        }
        for (int channel = 0; channel < RGB; channel++) {
            out[at + channel] = (float) sum[channel];
        }
    }

    private boolean isImpostor(int item) {
        return !occluders.isSolid(item)
                && occluders.shapeOf(item) instanceof StaticShape.TriangleMesh mesh
                && mesh.model().authored().impostor();
    }

    /** Writes the irradiance / π at a point; parameters as of {@link #leaving}. */
    public void arriving(int item, int face, Vec3 place, double[] rgb) {
        Arrays.fill(rgb, 0);
        for (int i = 0; i < layers.size(); i++) {
            int to = RGB * names.indexOf(layers.get(i).name());
            addArriving(layers.get(i), item, face, place, rgb, to);
        }
    }

    private void addArriving(IndirectLight.Layer light, int item, int face, Vec3 place, double[] rgb, int to) {
        if (occluders.isSolid(item)) {
            LightMapLookup.Spot spot = face < 0 ? null : spot(item, face, place);
            if (spot != null) {
                double column = spot.columnOf(place) - 0.5;
                double row = spot.rowOf(place) - 0.5;
                interpolate(light.texels(), layout.width(), layout.height(), column, row, rgb, to);
            }
        } else if (occluders.shapeOf(item) instanceof StaticShape.HeightGrid grid) {
            readGround(light, grid, place, rgb, to);
        } else if (occluders.shapeOf(item) instanceof StaticShape.TriangleMesh mesh) {
            Integer first = firstVertex.get(mesh.model());
            if (first != null) {
                int vertex = nearestVertex(mesh.model().triangles(), occluders.triangleOf(item), place);
                add(1, light.vertices(), first + vertex, rgb, to);
            }
        }
    }

    /** Returns the place on the light map of the uncovered fragment of a face that contains a point; {@code null} for none. */
    private LightMapLookup.Spot spot(int solid, int face, Vec3 place) {
        List<FaceFragment> parts = fragments.get(solid).get(face);
        Vec3 normal =
                occluders.shapes().solids().get(solid).faces().get(face).plane().normal();
        int found = -1;
        double deepest = Double.NEGATIVE_INFINITY;
        for (int part = 0; part < parts.size(); part++) {
            double depth = parts.get(part).isCovered() ? Double.NEGATIVE_INFINITY : depth(parts, part, normal, place);
            if (depth > deepest) {
                deepest = depth;
                found = part;
            }
        }
        if (found < 0) {
            return null;
        }
        if (spots[solid] == null) {
            spots[solid] = new LightMapLookup.Spot[fragments.get(solid).size()][];
        }
        if (spots[solid][face] == null) {
            spots[solid][face] = new LightMapLookup.Spot[parts.size()];
        }
        if (spots[solid][face][found] == null) {
            spots[solid][face][found] = lookup.of(solid, face, found, parts.get(found));
        }
        return spots[solid][face][found];
    }

    /** Returns the distance from a point of a fragment to its outline, negative outside; not computed for a face's only one. */
    private static double depth(List<FaceFragment> parts, int part, Vec3 normal, Vec3 place) {
        if (parts.size() == 1) {
            return 0;
        }
        List<Vec3> outline = parts.get(part).outline();
        double depth = Double.POSITIVE_INFINITY;
        for (int i = 0; i < outline.size(); i++) {
            Vec3 from = outline.get(i);
            Vec3 inward = normal.cross(outline.get((i + 1) % outline.size()).minus(from));
            depth = Math.min(depth, inward.dot(place.minus(from)) / inward.length());
        }
        return depth;
    }

    /** Returns the vertex of a triangle that is nearest to a point, of all vertices if {@code triangle} is −1. */
    private static int nearestVertex(WorldTriangles mesh, int triangle, Vec3 place) {
        int end = triangle < 0 ? mesh.vertices().length : 3 * triangle + 3;
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = Math.max(0, 3 * triangle); i < end; i++) {
            double square = mesh.corner(i / 3, i % 3)
                    .minus(place)
                    .dot(mesh.corner(i / 3, i % 3).minus(place));
            if (square < least) {
                least = square;
                nearest = mesh.vertices()[i];
            }
        }
        return nearest;
    }

    private void readGround(IndirectLight.Layer light, StaticShape.HeightGrid grid, Vec3 place, double[] rgb, int to) {
        HeightField field = grid.field();
        int columns = TerrainSky.points(field.cellColumns());
        int rows = TerrainSky.points(field.cellRows());
        int index = occluders.shapes().ground().indexOf(grid);
        if (index < light.grounds().size() && light.grounds().get(index).points() == columns * rows) {
            double x = (place.x() - field.x(0)) / (field.cellX() * field.cellColumns());
            double z = (place.z() - field.z(0)) / (field.cellZ() * field.cellRows());
            interpolate(light.grounds().get(index), columns, rows, x * (columns - 1), z * (rows - 1), rgb, to);
        }
    }

    /** Interpolates bilinearly between samples of a grid, whose first is at (0, 0). */
    private static void interpolate(
            LightSamples grid, int columns, int rows, double x, double y, double[] rgb, int to) {
        double column = Math.min(Math.max(x, 0), columns - 1);
        double row = Math.min(Math.max(y, 0), rows - 1);
        int left = Math.min((int) column, Math.max(columns - 2, 0));
        int low = Math.min((int) row, Math.max(rows - 2, 0));
        double right = column - left;
        double up = row - low;
        int at = low * columns + left;
        int next = columns > 1 ? 1 : 0;
        int above = rows > 1 ? columns : 0;
        add((1 - right) * (1 - up), grid, at, rgb, to);
        add(right * (1 - up), grid, at + next, rgb, to);
        add((1 - right) * up, grid, at + above, rgb, to);
        add(right * up, grid, at + above + next, rgb, to);
    }

    private static void add(double weight, LightSamples samples, int point, double[] rgb, int to) {
        for (int channel = 0; channel < RGB; channel++) {
            rgb[to + channel] += weight * samples.radiance()[RGB * point + channel];
        }
    }

    private void addLayers(StaticShape.HeightGrid grid, Vec3 place) {
        TerrainLayers layers = layersOf.computeIfAbsent(grid, ground -> TerrainLayers.of(ground.authored()));
        double[] weights = new double[Math.max(1, layers.count())];
        weights[0] = 1;
        if (layers.count() > 0) {
            double up = HeightFieldSurface.normal(grid.field(), place.x(), place.z())
                    .y();
            layers.weights(place.y() - grid.authored().centre().y(), up, weights);
            grid.painted().ifPresent(map -> new LayerPaint(grid.authored(), map).over(place.x(), place.z(), weights));
        }
        for (int i = 0; i < weights.length; i++) {
            addMaterial(weights[i], layers.count() == 0 ? null : layers.material(i));
        }
    }

    private void addMaterial(double weight, String id) {
        int index = materials.indexOf(id);
        if (reflectances[index] == null) {
            reflectances[index] = reflectanceOf(materials.surfaces().get(index));
        }
        Vec3 emitted = materials.surfaces().get(index).material().emission();
        for (int channel = 0; channel < RGB; channel++) {
            reflectance[channel] += weight * reflectances[index][channel];
        }
        emission[0] += weight * emitted.x();
        emission[1] += weight * emitted.y();
        emission[2] += weight * emitted.z();
    }

    private double[] reflectanceOf(Surface surface) {
        Material material = surface.material();
        double[] colour = {1, 1, 1};
        if (surface.colour().array() >= 0) {
            PictureArray array = materials.colourArrays().get(surface.colour().array());
            colour = mean(array.layers().get(surface.colour().layer()));
        }
        Vec3 base = material.baseColour().times(new Vec3(colour[0], colour[1], colour[2]));
        double metallic = material.metallic() == null ? 0 : material.metallic();
        double specular = material.lambert() ? 0 : SPECULAR_ALBEDO * (1 - metallic);
        Vec3 all = base.lerp(new Vec3(1, 1, 1), specular);
        return new double[] {all.x(), all.y(), all.z()};
    }

    private static double[] mean(Picture rgba) {
        double[] linear = ColourDecoding.SRGB.table();
        int step = Math.max(1, Math.max(rgba.width(), rgba.height()) / MEAN_PIXELS);
        double[] sum = new double[RGB];
        int count = 0;
        for (int y = step / 2; y < rgba.height(); y += step) {
            for (int x = step / 2; x < rgba.width(); x += step) {
                for (int channel = 0; channel < RGB; channel++) {
                    sum[channel] += linear[rgba.sample(x, y, channel)];
                }
                count++;
            }
        }
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }
}
