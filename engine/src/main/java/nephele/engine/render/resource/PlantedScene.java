package nephele.engine.render.resource;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.planted.PlantedModels;
import nephele.engine.level.planted.PlantedModels.Plant;
import nephele.engine.math.Aabb;
import nephele.engine.math.Pcg3d;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Scene;
import nephele.engine.scene.impostor.KindShape;

/** The models of a level that are drawn as impostors, on the GPU. Nothing of them changes from frame to frame. */
public final class PlantedScene implements GlObject {
    private static final int FLOATS = 8;
    private static final int PER_CLUSTER = 64;

    private final Vec3 anchor;
    private final PlantedKinds kinds;
    private final BufferTexture texels;
    private final List<Cluster> clusters = new ArrayList<>();
    private final int[] kindOf;
    /** The middles, three numbers each, from the anchor. */
    private final float[] middles;
    /** Diameters, metres. */
    private final float[] sizes;

    /**
     * Plants from {@code first} to before {@code end}.
     *
     * @param least diameter of the smallest, {@code most} of the largest
     */
    public record Cluster(int first, int end, Aabb bounds, double least, double most) {}

    public PlantedScene(GlContext gl, Scene scene, PlantSource source) {
        anchor = source.anchor();
        PlantedModels planted = PlantedModels.of(scene.level(), scene.statics(), scene.assets());
        kinds = new PlantedKinds(gl, planted.kinds(), scene.materials(), source);
        int count = planted.plants().size();
        kindOf = new int[count];
        middles = new float[3 * count];
        sizes = new float[count];
        float[] values = new float[FLOATS * Math.max(1, count)];
        BillboardSky sky = new BillboardSky(surroundings(scene.statics()), source.isSkyLit(), count);
        int at = 0;
        for (List<Plant> cluster : clustered(planted.plants())) {
            int first = at;
            for (Plant plant : cluster) {
                put(plant, sky, at, (at - first + 0.5) / cluster.size(), values);
                at++;
            }
            clusters.add(cluster(first, at));
        }
        texels = BufferTexture.ofFloats(gl, "plants", values);
    }

    /** Shares the level's models that are drawn as impostors. */
    public static PlantedScene of(LoadContext context) {
        PlantSource source = PlantSource.of(
                context.scene(),
                context.get(SurfaceLight.RESOURCE).anchor(),
                context.output().pictures(),
                context.output().decoding(),
                context.quality().impostorPixels());
        return context.share(PlantedScene.class, source, () -> new PlantedScene(context.gl(), context.scene(), source));
    }

    /** Returns the shapes without the models that are drawn as impostors: these have their own sky. */
    private static StaticShapes surroundings(StaticShapes statics) {
        List<PlacedModel> others = statics.models().all().stream()
                .filter(model -> !model.said().impostor())
                .toList();
        return statics.with(new PlacedModels(others));
    }

    /**
     * Returns the plants in clusters of near ones; within a cluster their order is random, so that its first ones stand
     * everywhere.
     */
    private static List<List<Plant>> clustered(List<Plant> plants) {
        Aabb box = Aabb.of(plants.stream().map(Plant::foot).toList());
        double area = box.isEmpty() ? 1 : (box.maxX() - box.minX()) * (box.maxZ() - box.minZ());
        double side = Math.max(1, Math.sqrt(area * PER_CLUSTER / Math.max(1, plants.size())));
        List<Integer> sorted = IntStream.range(0, plants.size())
                .boxed()
                .sorted(Comparator.comparingLong(i -> cell(plants.get(i).foot(), box, side)))
                .toList();
        List<List<Plant>> clusters = new ArrayList<>();
        for (int first = 0; first < sorted.size(); first += PER_CLUSTER) {
            clusters.add(sorted.subList(first, Math.min(first + PER_CLUSTER, sorted.size())).stream()
                    .sorted(Comparator.comparingInt(
                            number -> Pcg3d.of(number, 0, 0).x()))
                    .map(plants::get)
                    .toList());
        }
        return clusters;
    }

    /** Numbers cells row by row, every second row backwards, so that clusters which reach into the next cell stay compact. */
    private static long cell(Vec3 foot, Aabb box, double side) {
        long column = (long) ((foot.x() - box.minX()) / side);
        long row = (long) ((foot.z() - box.minZ()) / side);
        return (row << 32) + ((row & 1) == 0 ? column : (1L << 31) - column);
    }

    private void put(Plant plant, BillboardSky sky, int at, double rank, float[] values) {
        KindShape shape = kinds.shape(plant.kind());
        double scale = plant.scale();
        Vec3 centre = shape.centre();
        double cos = Math.cos(plant.turn());
        double sin = Math.sin(plant.turn());
        Vec3 middle = plant.foot()
                .addScaled(
                        scale,
                        new Vec3(cos * centre.x() + sin * centre.z(), centre.y(), cos * centre.z() - sin * centre.x()));
        plant.foot().minus(anchor).put(values, FLOATS * at, plant.kind());
        values[FLOATS * at + 4] = (float) scale;
        values[FLOATS * at + 5] = (float) plant.turn();
        values[FLOATS * at + 6] = sky.seenFrom(middle);
        values[FLOATS * at + 7] = (float) rank;
        Vec3 fromAnchor = middle.minus(anchor);
        middles[3 * at] = (float) fromAnchor.x();
        middles[3 * at + 1] = (float) fromAnchor.y();
        middles[3 * at + 2] = (float) fromAnchor.z();
        sizes[at] = (float) (2 * shape.radius() * scale);
        kindOf[at] = plant.kind();
    }

    private Cluster cluster(int first, int end) {
        Aabb bounds = Aabb.EMPTY;
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int i = first; i < end; i++) {
            Vec3 middle = new Vec3(middles[3 * i], middles[3 * i + 1], middles[3 * i + 2]).plus(anchor);
            bounds = bounds.union(Aabb.around(middle, new Vec3(sizes[i], sizes[i], sizes[i])));
            least = Math.min(least, sizes[i]);
            most = Math.max(most, sizes[i]);
        }
        return new Cluster(first, end, bounds, least, most);
    }

    public Vec3 anchor() {
        return anchor;
    }

    public List<Cluster> clusters() {
        return clusters;
    }

    public int count() {
        return kindOf.length;
    }

    public int kind(int plant) {
        return kindOf[plant];
    }

    /** Returns a plant's diameter, metres. */
    public float size(int plant) {
        return sizes[plant];
    }

    /** Returns a coordinate of a plant's middle from the anchor, metres. */
    public float middle(int plant, int axis) {
        return middles[3 * plant + axis];
    }

    public List<KindMesh> meshes() {
        return kinds.meshes();
    }

    /** Binds the numbers of plants and kinds. */
    public void bind() {
        texels.bind(TextureUnit.PLANTS);
        kinds.bindNumbers();
    }

    public void bindAtlases() {
        kinds.bindAtlases();
    }

    @Override
    public void close() {
        texels.close();
        kinds.close();
    }
}
