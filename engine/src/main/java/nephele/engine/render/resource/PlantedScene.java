package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.billboard.PlantedModels.Plant;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Pcg3d;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Scene;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.impostor.ImpostorAtlas;
import nephele.engine.scene.impostor.KindShape;
import nephele.engine.scene.impostor.KindSky;
import nephele.engine.scene.light.LightRequirements;
import org.lwjgl.system.MemoryUtil;

/** The models of a level that are drawn as impostors, on the GPU. Nothing of them changes from frame to frame. */
public final class PlantedScene implements GlObject {
    private static final int KIND_FLOATS = 16;
    private static final int PLANT_FLOATS = 8;
    private static final int PER_CLUSTER = 64;

    private final OwnedObjects owned;
    private final Vec3 anchor;
    private final List<KindShape> shapes = new ArrayList<>();
    private final List<KindMesh> meshes = new ArrayList<>();
    /** The atlases of kinds, a layer each. */
    private final Texture colours;

    private final Texture normals;
    private final BufferTexture kindNumbers;
    private final BufferTexture plantNumbers;
    /** {@code null} without baked light. */
    private final BufferTexture bounced;

    private final List<Cluster> clusters = new ArrayList<>();
    private final int[] kindOf;
    /** The middles, three numbers each, from the anchor. */
    private final float[] middles;
    /** Diameters, metres. */
    private final float[] sizes;

    /** What is derived from a kind's mesh without its material. */
    private record Form(KindShape shape, KindSky sky) {
        static Form of(PlantedModels.Kind kind) {
            KindShape shape = KindShape.of(kind);
            return new Form(shape, KindSky.of(shape));
        }
    }

    /**
     * Plants from {@code first} to before {@code end}.
     *
     * @param least diameter of the smallest, {@code most} of the largest
     */
    public record Cluster(int first, int end, Aabb bounds, double least, double most) {}

    private PlantedScene(LoadContext context, Vec3 anchor, int texels) {
        this.anchor = anchor;
        GlContext gl = context.gl();
        Scene scene = context.scene();
        owned = new OwnedObjects(gl);
        PlantedModels planted = PlantedModels.of(scene.level(), scene.statics(), scene.assets());
        int side = ImpostorAtlas.SIDE * texels;
        Texture.Extent extent =
                new Texture.Extent(side, side, Math.max(1, planted.kinds().size()));
        PixelFormat format = context.output().pictures();
        colours = owned.own(
                new Texture(gl, "impostor colours", Texture.Shape.ARRAY, format, extent, Sampling.MIPMAPPED_CLAMP));
        normals = owned.own(new Texture(
                gl, "impostor shapes", Texture.Shape.ARRAY, PixelFormat.RGBA8, extent, Sampling.MIPMAPPED_CLAMP));
        float[] kinds = new float[KIND_FLOATS * Math.max(1, planted.kinds().size())];
        for (PlantedModels.Kind kind : planted.kinds()) {
            add(kind, context, texels, kinds);
        }
        kindNumbers = owned.own(BufferTexture.ofFloats(gl, "plant kinds", kinds));
        int count = planted.plants().size();
        kindOf = new int[count];
        middles = new float[3 * count];
        sizes = new float[count];
        float[] plants = new float[PLANT_FLOATS * Math.max(1, count)];
        BillboardSky sky = new BillboardSky(context, surroundings(scene.statics()), count);
        int at = 0;
        for (List<Plant> cluster : clustered(planted.plants())) {
            int first = at;
            for (Plant plant : cluster) {
                put(plant, sky, at, (at - first + 0.5) / cluster.size(), plants);
                at++;
            }
            clusters.add(cluster(first, at));
        }
        plantNumbers = owned.own(BufferTexture.ofFloats(gl, "plants", plants));
        bounced = sky.bounced(gl);
        if (bounced != null) {
            owned.own(bounced);
        }
    }

    /** Shares the level's models that are drawn as impostors. */
    public static PlantedScene of(LoadContext context) {
        Scene scene = context.scene();
        Vec3 anchor = context.get(SurfaceLight.RESOURCE).anchor();
        int texels = ImpostorAtlas.texelsFor(context.quality().impostorPixels());
        List<Object> madeFrom = List.of(
                new Identity(scene.statics()),
                new Identity(scene.materials()),
                new Identity(scene.assets()),
                LightRequirements.skyShines(scene.level()),
                AmbientLight.bouncedKey(scene),
                anchor,
                context.output().pictures(),
                texels);
        return context.share(PlantedScene.class, madeFrom, () -> new PlantedScene(context, anchor, texels));
    }

    /** Adds a kind with its mesh, its atlases and its numbers. @param texels along a side of a view of an atlas */
    private void add(PlantedModels.Kind kind, LoadContext context, int texels, float[] values) {
        SceneMaterials materials = context.scene().materials();
        ColourDecoding decoding = context.output().decoding();
        Form form = owned.shareValue(
                Form.class, List.of(new Identity(kind.mesh()), kind.plantFromModel()), () -> Form.of(kind));
        Surface surface = materials.surfaces().get(materials.indexOf(kind.material()));
        Picture picture = picture(surface, materials);
        ImpostorAtlas atlas = owned.shareValue(
                ImpostorAtlas.class,
                List.of(new Identity(form), surface.material(), new Identity(picture), decoding, texels),
                () -> ImpostorAtlas.of(form.shape(), surface.material(), picture, decoding, texels));
        upload(meshes.size(), atlas);
        put(form, surface.material().emission(), KIND_FLOATS * meshes.size(), values);
        shapes.add(form.shape());
        meshes.add(owned.own(new KindMesh(context.gl(), form.shape(), form.sky(), surface)));
    }

    private static Picture picture(Surface surface, SceneMaterials materials) {
        int array = surface.colour().array();
        return array < 0
                ? null
                : materials
                        .colourArrays()
                        .get(array)
                        .layers()
                        .get(surface.colour().layer());
    }

    private static void put(Form form, Vec3 emission, int at, float[] values) {
        KindShape shape = form.shape();
        shape.centre().put(values, at, shape.halfWidth());
        values[at + 4] = (float) shape.halfHeight();
        values[at + 5] = (float) shape.radius();
        System.arraycopy(form.sky().fit(), 0, values, at + 8, 4);
        emission.put(values, at + 12, 0);
    }

    private void upload(int layer, ImpostorAtlas atlas) {
        ByteBuffer texels = MemoryUtil.memAlloc(4 * atlas.side() * atlas.side());
        try {
            for (int level = 0; level < atlas.colours().size(); level++) {
                colours.uploadLevel(
                        level,
                        layer,
                        texels.clear().put(atlas.colours().get(level)).flip());
                normals.uploadLevel(
                        level,
                        layer,
                        texels.clear().put(atlas.shapes().get(level)).flip());
            }
        } finally {
            MemoryUtil.memFree(texels);
        }
    }

    /** Returns the shapes without the models that are drawn as impostors: these have their own sky. */
    private static StaticShapes surroundings(StaticShapes statics) {
        List<PlacedModel> others = statics.models().all().stream()
                .filter(model -> !model.authored().impostor())
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
        KindShape shape = shapes.get(plant.kind());
        double scale = plant.scale();
        Vec3 centre = shape.centre();
        double cos = Math.cos(plant.turn());
        double sin = Math.sin(plant.turn());
        Vec3 middle = plant.foot()
                .addScaled(
                        scale,
                        new Vec3(cos * centre.x() + sin * centre.z(), centre.y(), cos * centre.z() - sin * centre.x()));
        plant.foot().minus(anchor).put(values, PLANT_FLOATS * at, plant.kind());
        values[PLANT_FLOATS * at + 4] = (float) scale;
        values[PLANT_FLOATS * at + 5] = (float) plant.turn();
        values[PLANT_FLOATS * at + 6] = sky.find(at, middle);
        values[PLANT_FLOATS * at + 7] = (float) rank;
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
        return meshes;
    }

    /** Binds the numbers of plants and kinds. */
    public void bind() {
        plantNumbers.bind(TextureUnit.PLANTS);
        kindNumbers.bind(TextureUnit.PLANT_KINDS);
        if (bounced != null) {
            bounced.bind(TextureUnit.BOUNCED_LIGHT);
        }
    }

    public void bindAtlases() {
        colours.bind(TextureUnit.COLOURS);
        normals.bind(TextureUnit.IMPOSTOR_SHAPES);
    }

    @Override
    public void close() {
        owned.close();
    }
}
