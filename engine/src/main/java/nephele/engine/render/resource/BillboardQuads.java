package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.Billboards;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.billboard.Sway;
import nephele.engine.math.Aabb;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.SpriteCoverage;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import org.lwjgl.system.MemoryUtil;

/**
 * The images of a level's billboards on the GPU, in clusters of near ones. A crossed billboard has two images. Nothing of
 * them changes from frame to frame but the numbers of their groups.
 */
public final class BillboardQuads implements GlObject {
    private static final int PER_CLUSTER = 64;
    private static final int FLOATS = 8;
    /** Five texels a group. */
    private static final int GROUP_FLOATS = 20;

    private static final int BALL = 4;

    /** How billboards are drawn. */
    public enum Kind {
        /** Where they cover half or more; they write depth and cast shadows. */
        WITH_EDGES,
        /** Over what is behind them, the farthest first. */
        BLENDED
    }

    private final Vec3 anchor;
    private final BillboardSprites sprites;
    private final List<Billboards> groups;
    /** What all billboards of a group share; uploaded again when time moves any of them. */
    private final BufferTexture groupTexels;

    private final FloatBuffer groupValues;
    private final boolean moves;
    private double uploadedSeconds = Double.NaN;
    private final BufferTexture texels;
    /** {@code null} without baked light. */
    private final BufferTexture bounced;

    private final List<Cluster> clusters = new ArrayList<>();
    private final int[] arrays;
    /** The middles from the anchor, and half of the longer sides. */
    private final float[] balls;

    /**
     * Images from {@code first} to before {@code end} that have pictures of one array.
     *
     * @param bounds in the world, however they are turned
     */
    public record Cluster(int first, int end, int array, Aabb bounds) {}

    /** An image before it is stored. */
    private record Image(PlantedBillboards.Group group, int number, int index, double turn, int array) {
        Vec3 foot() {
            return group.feet().get(index);
        }
    }

    private BillboardQuads(LoadContext context, Kind kind, Vec3 anchor) {
        this.anchor = anchor;
        GlContext gl = context.gl();
        Scene scene = context.scene();
        List<PlantedBillboards.Group> drawn =
                PlantedBillboards.of(scene.level(), scene.statics(), scene.assets()).groups().stream()
                        .filter(group -> group.authored().blended() == (kind == Kind.BLENDED))
                        .toList();
        List<Billboards> authored =
                drawn.stream().map(PlantedBillboards.Group::authored).toList();
        sprites = new BillboardSprites(gl, authored, scene.assets(), context.output(), keepsCoverage(context, kind));
        groups = authored;
        moves = groups.stream().anyMatch(Billboards::moves);
        groupTexels = BufferTexture.changing(gl, "billboard groups");
        groupValues = MemoryUtil.memAllocFloat(GROUP_FLOATS * Math.max(1, groups.size()));
        List<Image> images = images(drawn);
        arrays = images.stream().mapToInt(Image::array).toArray();
        balls = new float[BALL * images.size()];
        float[] values = new float[FLOATS * images.size()];
        BillboardSky sky = new BillboardSky(context, scene.statics(), images.size());
        for (int i = 0; i < images.size(); i++) {
            put(images.get(i), sky, i, values);
        }
        texels = BufferTexture.ofFloats(gl, "billboards", values);
        bounced = sky.bounced(gl);
        cluster(images);
    }

    /** Shares the level's billboards of a kind. */
    public static BillboardQuads of(LoadContext context, Kind kind) {
        Scene scene = context.scene();
        Vec3 anchor = context.get(SurfaceLight.RESOURCE).anchor();
        List<Object> madeFrom = List.of(
                new Identity(scene.level().billboards()),
                new Identity(scene.statics().solids()),
                new Identity(scene.statics().models()),
                new Identity(scene.assets()),
                LightRequirements.skyShines(scene.level()),
                AmbientLight.bouncedKey(scene),
                kind,
                anchor,
                context.output().pictures(),
                keepsCoverage(context, kind));
        return context.share(BillboardQuads.class, madeFrom, () -> new BillboardQuads(context, kind, anchor));
    }

    /** Returns true if smaller mipmap levels keep the part of a picture that is drawn. */
    private static boolean keepsCoverage(LoadContext context, Kind kind) {
        return kind == Kind.WITH_EDGES && context.quality().spriteCoverage() == SpriteCoverage.KEPT;
    }

    private List<Image> images(List<PlantedBillboards.Group> drawn) {
        List<Image> images = new ArrayList<>();
        for (int number = 0; number < drawn.size(); number++) {
            PlantedBillboards.Group group = drawn.get(number);
            int array = sprites.place(group.authored()).array();
            for (int i = 0; i < group.feet().size(); i++) {
                double turn = group.turn(i);
                images.add(new Image(group, number, i, turn, array));
                if (group.authored().facing() == Billboards.Facing.CROSSED) {
                    images.add(new Image(group, number, i, turn + StrictMath.PI / 2, array));
                }
            }
        }
        double side = cellMetres(images);
        images.sort(Comparator.<Image>comparingInt(Image::array)
                .thenComparingLong(image -> cell(image.foot(), side))
                .thenComparingInt(Image::number)
                .thenComparingInt(Image::index)
                .thenComparingDouble(Image::turn));
        return images;
    }

    /** Returns the side of squares that hold a cluster each, if places are spread evenly. */
    private static double cellMetres(List<Image> images) {
        Aabb box = Aabb.of(images.stream().map(Image::foot).toList());
        double area = box.isEmpty() ? 1 : (box.maxX() - box.minX()) * (box.maxZ() - box.minZ());
        return Math.max(1, Math.sqrt(area * PER_CLUSTER / Math.max(1, images.size())));
    }

    private long cell(Vec3 foot, double side) {
        long x = (long) Math.floor((foot.x() - anchor.x()) / side);
        long z = (long) Math.floor((foot.z() - anchor.z()) / side);
        return (x << 32) + z;
    }

    private void put(Image image, BillboardSky sky, int at, float[] values) {
        Vec3 foot = image.foot().minus(anchor);
        double scale = image.group().scale(image.index());
        double half = image.group().authored().sizeMetres().height() * scale / 2;
        int to = FLOATS * at;
        foot.put(values, to, image.number());
        values[to + 4] = (float) scale;
        values[to + 5] = (float) image.group().phase(image.index());
        values[to + 6] = sky.find(at, image.foot().plus(new Vec3(0, half, 0)));
        values[to + 7] = (float) image.turn();
        double width = image.group().authored().sizeMetres().width() * scale;
        foot.plus(new Vec3(0, half, 0)).put(balls, BALL * at, (float) Math.max(half, width / 2));
    }

    private void cluster(List<Image> images) {
        int first = 0;
        Aabb bounds = Aabb.EMPTY;
        for (int i = 0; i < images.size(); i++) {
            Image image = images.get(i);
            bounds = bounds.union(image.group().bounds(image.index()));
            boolean isLast = i + 1 == images.size() || images.get(i + 1).array() != image.array();
            if (isLast || i + 1 - first == PER_CLUSTER) {
                clusters.add(new Cluster(first, i + 1, image.array(), bounds));
                first = i + 1;
                bounds = Aabb.EMPTY;
            }
        }
    }

    /** Collects the clusters that may be visible, by arrays of pictures, then by place. */
    public void findVisible(Frustum frustum, List<Cluster> visible) {
        visible.clear();
        for (int i = 0; i < clusters.size(); i++) {
            if (frustum.mayIntersect(clusters.get(i).bounds())) {
                visible.add(clusters.get(i));
            }
        }
    }

    public List<Cluster> clusters() {
        return clusters;
    }

    public int count() {
        return balls.length / BALL;
    }

    /** Returns the array that holds an image's picture. */
    public int array(int image) {
        return arrays[image];
    }

    /** Returns a coordinate of an image's middle from the anchor, metres. */
    public float middle(int image, int axis) {
        return balls[BALL * image + axis];
    }

    /** Returns half of an image's longer side, metres. */
    public float half(int image) {
        return balls[BALL * image + 3];
    }

    /** Moves them to a time. */
    public void follow(double seconds) {
        if (seconds == uploadedSeconds || !moves && !Double.isNaN(uploadedSeconds)) {
            return;
        }
        uploadedSeconds = seconds;
        groupValues.clear();
        for (Billboards group : groups) {
            double wind = group.windMetresPerSecond();
            put(
                    group.sizeMetres().width(),
                    group.sizeMetres().height(),
                    group.facing().ordinal(),
                    sprites.place(group).layer());
            put(frame(group, seconds), group.frames(), group.framesPerSecond() > 0 ? 1 : 0, 0);
            put(Sway.lean(wind), Sway.SWINGING, Sway.turns(seconds), Sway.turnsPerMetre(wind));
            put(group.colour() == null ? Vec3.ZERO : group.colour(), group.colour() == null ? 0 : 1);
            put(group.emission(), 0);
        }
        groupTexels.upload(groupValues.flip());
    }

    /** Returns the frame at a time, from 0 to less than the number of frames; exact after years. */
    private static double frame(Billboards group, double seconds) {
        double rounds = seconds * group.framesPerSecond() / group.frames();
        return (rounds - Math.floor(rounds)) * group.frames();
    }

    private void put(Vec3 v, double w) {
        put(v.x(), v.y(), v.z(), w);
    }

    private void put(double x, double y, double z, double w) {
        groupValues.put((float) x).put((float) y).put((float) z).put((float) w);
    }

    /** Binds the numbers of all images. */
    public void bind() {
        texels.bind(TextureUnit.BILLBOARDS);
        groupTexels.bind(TextureUnit.BILLBOARD_GROUPS);
        if (bounced != null) {
            bounced.bind(TextureUnit.BOUNCED_LIGHT);
        }
    }

    /** Binds the pictures of an array. */
    public void bindSprites(int array) {
        sprites.bind(array);
    }

    @Override
    public void close() {
        texels.close();
        if (bounced != null) {
            bounced.close();
        }
        groupTexels.close();
        MemoryUtil.memFree(groupValues);
        sprites.close();
    }
}
