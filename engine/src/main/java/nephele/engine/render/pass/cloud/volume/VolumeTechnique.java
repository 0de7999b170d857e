package nephele.engine.render.pass.cloud.volume;

import java.nio.ByteBuffer;
import java.nio.ShortBuffer;
import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.noise.EvolvingNoise;
import nephele.engine.cloud.noise.PeriodicTable;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPrograms;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * Marches rays through the cells of a cloud; the density of noise with a profile is not looked up in cells but computed from
 * the tables of the noise.
 */
public final class VolumeTechnique implements CloudDrawing {
    public static final Technique REGISTERED =
            new Technique(CloudTechnique.VOLUME, cloud -> true, VolumeTechnique::new);

    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final LitCloud lit;
    private final CloudPrograms<MarchUniforms> programs;
    private final FullScreenTriangle triangle;
    private final double stepCells;
    /** {@code null} if the density comes from cells. */
    private final NoiseTextures noiseTextures;

    /** Its noise at the time; {@code null} if the density comes from cells. */
    private NoiseField noise;

    private record MarchUniforms(
            CloudPrograms.Shared cloud,
            @IfRead NoiseTextures.Places noise,
            Uniforms.Vector4 cellEdges,
            Uniforms.Vector4 stepping) {}

    private VolumeTechnique(CloudContext context, PlacedCloud placed) {
        this.placed = placed;
        cloud = placed.source();
        lit = new LitCloud(context.load(), placed);
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "volume"));
        stepCells = context.load().quality().cloudStep();
        boolean isOctaves = context.load().quality().cloudScattering() == CloudScattering.OCTAVES;
        programs = new CloudPrograms<>(
                context,
                "cloud.vert",
                "volume/volume.frag",
                defines -> lit.define(defines)
                        .withIf(cloud.isProfiled(), "NOISE")
                        .withIf(cloud.isProfiled() && cloud.evolves(), "EVOLVING")
                        .withIf(isOctaves, "OCTAVES"),
                MarchUniforms.class);
        noiseTextures = cloud.isProfiled()
                ? new NoiseTextures(
                        context.load(), (ProfiledNoise) cloud.noise(0).density(), cloud.levels())
                : null;
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
        if (noiseTextures != null) {
            noise = cloud.noise(cloud.evolves() ? now.seconds() : 0);
            noiseTextures.upload(lit.earlier().boxes(), lit.later().boxes());
        }
    }

    @Override
    public void draw(CloudCanvas canvas) {
        MarchUniforms uniforms = programs.use(canvas.pixels());
        View view = canvas.view();
        canvas.put(uniforms.cloud, placed);
        lit.put(uniforms.cloud, view, canvas.focus());
        if (noiseTextures != null) {
            noiseTextures.bind(uniforms.noise, noise, view.eye().minus(placed.drift()));
        }
        CellBox narrowest = lit.earlier().cells().narrowest();
        Vec3 edges = new Vec3(narrowest.sizeX(), narrowest.sizeY(), narrowest.sizeZ());
        uniforms.cellEdges.set(edges, narrowest.shortest());
        uniforms.stepping.set(stepCells, 0.5, view.eyeY(), canvas.pixels().isLook() ? lit.depthAround(view) : 0);
        triangle.draw();
    }

    /** Noise with a profile as {@code cloud-noise.glsl} reads it: tables that repeat, and a plan of the cloud's bodies. */
    private static final class NoiseTextures {
        private final Texture shape;
        private final Texture detail;
        private final Texture profile;
        private final Texture plan;
        private List<CloudSource.Box> uploadedFrom;
        private List<CloudSource.Box> uploadedTo;

        /** The uniforms of {@code cloud-noise.glsl}. */
        private record Places(
                Uniforms.Vector4 shapePlace,
                Uniforms.Vector4 detailPlace,
                @IfRead Uniforms.Vector3 shapeComing,
                @IfRead Uniforms.Vector3 detailComing,
                @IfRead Uniforms.Vector4 generations,
                Uniforms.Scalar eroding) {}

        private NoiseTextures(LoadContext context, ProfiledNoise noise, int boxes) {
            shape = table(context, "cloud shape", noise.shape().table());
            detail = table(context, "cloud detail", noise.detail().table());
            profile = context.own(new Texture(
                    context.gl(),
                    "cloud profile",
                    Texture.Shape.FLAT,
                    PixelFormat.RGBA32F,
                    Texture.Extent.flat(ProfiledNoise.KNOTS, 1),
                    Sampling.LINEAR_CLAMP));
            ByteBuffer knots = MemoryUtil.memAlloc(Float.BYTES * 4 * ProfiledNoise.KNOTS);
            knots.asFloatBuffer().put(noise.profile());
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

        private static void place(
                EvolvingNoise noise, Vec3 fromOrigin, Uniforms.Vector4 fading, Uniforms.Vector3 coming) {
            double period = noise.periodMetres();
            Vec3 eye = fromOrigin.scaled(1 / period);
            fading.set(fraction(eye.plus(noise.fadingOffset())), 1 / period);
            coming.set(fraction(eye.plus(noise.comingOffset())));
        }

        private static Vec3 fraction(Vec3 v) {
            return new Vec3(v.x() - Math.floor(v.x()), v.y() - Math.floor(v.y()), v.z() - Math.floor(v.z()));
        }
    }
}
