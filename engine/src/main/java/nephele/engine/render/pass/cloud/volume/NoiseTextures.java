package nephele.engine.render.pass.cloud.volume;

import java.nio.ByteBuffer;
import java.nio.ShortBuffer;
import java.util.List;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.field.HeightProfile;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.cloud.noise.PeriodicTable;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import org.lwjgl.system.MemoryUtil;

/** Noise with a profile as {@code cloud-noise.glsl} reads it: tables that repeat, and a plan of the cloud's bodies. */
final class NoiseTextures {
    private final Texture shape;
    private final Texture detail;
    private final Texture profile;
    private final Texture plan;
    private List<CloudSource.Box> uploadedFrom;
    private List<CloudSource.Box> uploadedTo;

    /** The uniforms of {@code cloud-noise.glsl}. */
    record Places(
            Uniforms.Vector4 shapePlace,
            Uniforms.Vector4 detailPlace,
            @IfRead Uniforms.Vector3 shapeComing,
            @IfRead Uniforms.Vector3 detailComing,
            @IfRead Uniforms.Vector4 generations,
            Uniforms.Scalar eroding) {}

    NoiseTextures(LoadContext context, ProfiledNoise noise, int boxes) {
        shape = table(context, "cloud shape", noise.shape().table());
        detail = table(context, "cloud detail", noise.detail().table());
        profile = context.own(new Texture(
                context.gl(),
                "cloud profile",
                Texture.Shape.FLAT,
                PixelFormat.RGBA32F,
                Texture.Extent.flat(HeightProfile.KNOTS, 1),
                Sampling.LINEAR_CLAMP));
        ByteBuffer knots = MemoryUtil.memAlloc(Float.BYTES * 4 * HeightProfile.KNOTS);
        knots.asFloatBuffer().put(noise.profile().knots());
        profile.upload(0, knots);
        MemoryUtil.memFree(knots);
        plan = context.own(new Texture(
                context.gl(),
                "cloud plan",
                Texture.Shape.ARRAY,
                PixelFormat.RG16,
                new Texture.Extent(CloudSource.PLAN_COLUMNS, CloudSource.PLAN_COLUMNS, boxes),
                Sampling.LINEAR_CLAMP));
    }

    private static Texture table(LoadContext context, String name, PeriodicTable table) {
        int size = table.size();
        var texture = context.own(new Texture(
                context.gl(),
                name,
                Texture.Shape.VOLUME,
                PixelFormat.R16,
                new Texture.Extent(size, size, size),
                Sampling.LINEAR_REPEAT));
        short[] values = table.unorm16();
        ByteBuffer slice = MemoryUtil.memAlloc(Short.BYTES * size * size);
        for (int k = 0; k < size; k++) {
            slice.clear().asShortBuffer().put(values, k * size * size, size * size);
            texture.upload(k, slice.clear());
        }
        MemoryUtil.memFree(slice);
        return texture;
    }

    /** Uploads the plans of two times unless they are there. */
    void upload(List<CloudSource.Box> from, List<CloudSource.Box> to) {
        if (from == uploadedFrom && to == uploadedTo) {
            return;
        }
        uploadedFrom = from;
        uploadedTo = to;
        int texelsOfPlan = CloudSource.PLAN_COLUMNS * CloudSource.PLAN_COLUMNS;
        ByteBuffer texels = MemoryUtil.memAlloc(2 * Short.BYTES * texelsOfPlan);
        for (int box = 0; box < from.size(); box++) {
            ShortBuffer pairs = texels.clear().asShortBuffer();
            short[] first = from.get(box).plan();
            short[] second = to.get(box).plan();
            for (int at = 0; at < texelsOfPlan; at++) {
                pairs.put(first[at]).put(second[at]);
            }
            plan.upload(box, texels.clear());
        }
        MemoryUtil.memFree(texels);
    }

    /** @param eye in the space that drifts with the cloud */
    void bind(Places places, NoiseField field, Vec3 eye) {
        shape.bind(TextureUnit.CLOUD_SHAPE);
        detail.bind(TextureUnit.CLOUD_DETAIL);
        profile.bind(TextureUnit.CLOUD_PROFILE);
        plan.bind(TextureUnit.CLOUD_PLAN);
        var noise = (ProfiledNoise) field.density();
        place(noise.shape(), eye.minus(field.origin()), places.shapePlace(), places.shapeComing());
        place(noise.detail(), eye.minus(field.origin()), places.detailPlace(), places.detailComing());
        places.generations.set(
                noise.shape().fadingWeight(),
                noise.shape().comingWeight(),
                noise.detail().fadingWeight(),
                noise.detail().comingWeight());
        places.eroding.set(noise.eroding());
    }

    private static void place(EvolvingNoise noise, Vec3 fromOrigin, Uniforms.Vector4 fading, Uniforms.Vector3 coming) {
        double period = noise.periodMetres();
        Vec3 eye = fromOrigin.scaled(1 / period);
        fading.set(fraction(eye.plus(noise.fadingOffset())), 1 / period);
        coming.set(fraction(eye.plus(noise.comingOffset())));
    }

    private static Vec3 fraction(Vec3 v) {
        return new Vec3(v.x() - Math.floor(v.x()), v.y() - Math.floor(v.y()), v.z() - Math.floor(v.z()));
    }
}
