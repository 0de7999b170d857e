package nephele.engine.render.pass.cloud.volume;

import java.nio.ByteBuffer;
import java.nio.ShortBuffer;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.field.HeightProfile;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.cloud.noise.EvolvingNoise.Generation;
import nephele.engine.cloud.noise.PeriodicTable;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/** Noise with a profile as {@code cloud-noise.glsl} reads it: tables that repeat, and a plan of the cloud's bodies. */
final class NoiseTextures {
    /** Texels of the plan along each side of a box. */
    private static final int PLAN = 512;

    private final Texture shape;
    private final Texture detail;
    private final Texture profile;
    private final Texture plan;

    /** The uniforms of {@code cloud-noise.glsl}. */
    record Places(
            Uniforms.Vector4 shapePlace,
            Uniforms.Vector4 detailPlace,
            Uniforms.Vector3 shapeComing,
            Uniforms.Vector3 detailComing,
            Uniforms.Vector4 generations,
            Uniforms.Scalar eroding) {
        static Places of(Uniforms uniforms, boolean evolving) {
            uniforms.sampler("shapeTable", TextureUnit.CLOUD_SHAPE);
            uniforms.sampler("detailTable", TextureUnit.CLOUD_DETAIL);
            uniforms.sampler("profileTable", TextureUnit.CLOUD_PROFILE);
            uniforms.sampler("planTable", TextureUnit.CLOUD_PLAN);
            return new Places(
                    uniforms.vector4("shapePlace"),
                    uniforms.vector4("detailPlace"),
                    evolving ? uniforms.vector3("shapeComing") : null,
                    evolving ? uniforms.vector3("detailComing") : null,
                    evolving ? uniforms.vector4("generations") : null,
                    uniforms.scalar("eroding"));
        }
    }

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
                PixelFormat.R16,
                new Texture.Extent(PLAN, PLAN, boxes),
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

    /** Draws the plan of each box anew. */
    void uploadPlan(NoiseField field, CellStack cells) {
        var noise = (ProfiledNoise) field.density();
        ByteBuffer texels = MemoryUtil.memAlloc(Short.BYTES * PLAN * PLAN);
        for (int box = 0; box < cells.levels(); box++) {
            putPlan(
                    noise,
                    field.origin(),
                    cells.density().get(box).cells(),
                    texels.clear().asShortBuffer());
            plan.upload(box, texels.clear());
        }
        MemoryUtil.memFree(texels);
    }

    private static void putPlan(ProfiledNoise noise, Vec3 origin, CellBox cells, ShortBuffer texels) {
        Aabb box = cells.box();
        double x = (box.maxX() - box.minX()) / PLAN;
        double z = (box.maxZ() - box.minZ()) / PLAN;
        java.util.stream.IntStream.range(0, PLAN).parallel().forEach(row -> {
            for (int column = 0; column < PLAN; column++) {
                double depth = noise.bodyDepth(
                        box.minX() + (column + 0.5) * x - origin.x(), box.minZ() + (row + 0.5) * z - origin.z());
                double stored = Math.max(0, Math.min(1, (depth + 1) / 2));
                texels.put(row * PLAN + column, (short) Math.round(65535 * stored));
            }
        });
    }

    void bind(Places places, NoiseField field, View view) {
        shape.bind(TextureUnit.CLOUD_SHAPE);
        detail.bind(TextureUnit.CLOUD_DETAIL);
        profile.bind(TextureUnit.CLOUD_PROFILE);
        plan.bind(TextureUnit.CLOUD_PLAN);
        var noise = (ProfiledNoise) field.density();
        place(noise.shape(), field.origin(), view, places.shapePlace(), places.shapeComing());
        place(noise.detail(), field.origin(), view, places.detailPlace(), places.detailComing());
        if (places.generations() != null) {
            places.generations()
                    .set(
                            (float) noise.shape().weight(Generation.FADING),
                            (float) noise.shape().weight(Generation.COMING),
                            (float) noise.detail().weight(Generation.FADING),
                            (float) noise.detail().weight(Generation.COMING));
        }
        places.eroding().set((float) noise.eroding());
    }

    private static void place(
            EvolvingNoise noise, Vec3 origin, View view, Uniforms.Vector4 fading, Uniforms.Vector3 coming) {
        double period = noise.layout().periodMetres();
        Vec3 eye = view.eye().minus(origin).scaled(1 / period);
        Vec3 first = fraction(eye.plus(noise.offset(Generation.FADING)));
        fading.set((float) first.x(), (float) first.y(), (float) first.z(), (float) (1 / period));
        if (coming != null) {
            Vec3 second = fraction(eye.plus(noise.offset(Generation.COMING)));
            coming.set((float) second.x(), (float) second.y(), (float) second.z());
        }
    }

    private static Vec3 fraction(Vec3 v) {
        return new Vec3(v.x() - Math.floor(v.x()), v.y() - Math.floor(v.y()), v.z() - Math.floor(v.z()));
    }
}
