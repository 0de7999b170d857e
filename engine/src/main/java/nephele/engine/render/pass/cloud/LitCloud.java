package nephele.engine.render.pass.cloud;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.SmallAngleScattering;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;
import org.lwjgl.system.MemoryUtil;

/**
 * A cloud as shaders light it: its cells at two sampled times in textures, and the light around it at the time of the frame.
 */
public final class LitCloud {
    private final AmbientLight ambient;
    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final Texture density;
    private final Texture smallAngles;
    private Texture light;
    /** {@code null} if the cloud never changes. */
    private Texture lightToCome;

    private final boolean isSteady;
    /** The cells whose light {@link #light} holds. */
    private CellStack lightOf;

    private CellStack lightToComeOf;
    /** The cells whose densities the texture holds. */
    private CellStack densityFrom;

    private CellStack densityTo;

    private Environment followed;
    private OutsideOfCloud around;
    private DrawnCloud earlier;
    private DrawnCloud later;
    private double fraction;
    private double groundFraction;

    public LitCloud(LoadContext context, PlacedCloud placed) {
        ambient = context.get(AmbientLight.RESOURCE);
        this.placed = placed;
        cloud = placed.source();
        CellBox cells = cloud.narrowest();
        density = volume(context, "cloud density", PixelFormat.RGBA8, cells, cloud.levels());
        CellBox lit = cells.coarser(context.quality().cloudLightCell());
        light = volume(context, "cloud light", PixelFormat.RGBA16F, lit, cloud.levels());
        isSteady = context.get(RendererClouds.RESOURCE).current().isSteady();
        lightToCome =
                isSteady ? null : volume(context, "cloud light to come", PixelFormat.RGBA16F, lit, cloud.levels());
        smallAngles = context.own(new Texture(
                context.gl(),
                "small-angle scattering",
                Texture.Shape.FLAT,
                PixelFormat.R32F,
                Texture.Extent.flat(SmallAngleScattering.SEPARATIONS, SmallAngleScattering.DEPTHS),
                Sampling.LINEAR_CLAMP));
        FloatBuffer texels = MemoryUtil.memAllocFloat(SmallAngleScattering.SEPARATIONS * SmallAngleScattering.DEPTHS);
        texels.put(cloud.physics().smallAngles().values()).flip();
        smallAngles.upload(0, MemoryUtil.memByteBuffer(texels));
        MemoryUtil.memFree(texels);
    }

    private static Texture volume(LoadContext context, String name, PixelFormat format, CellBox cells, int boxes) {
        return context.own(new Texture(
                context.gl(),
                name,
                Texture.Shape.VOLUME,
                format,
                new Texture.Extent(cells.nx(), cells.ny() * boxes, cells.nz()),
                Sampling.LINEAR_CLAMP));
    }

    /** Returns definitions of {@code cloud-light.glsl} and {@code cell-boxes.glsl} besides those of a technique. */
    public Defines define(Defines others) {
        return others.withIf(isSteady, "STEADY").withIf(cloud.levels() == 1, "ONE_BOX");
    }

    /** Takes its cells and the light around it at the time of the frame. */
    public void follow(Environment environment, CloudInterval now) {
        earlier = now.from().clouds().get(placed.index());
        later = now.to().clouds().get(placed.index());
        fraction = now.fraction();
        groundFraction = now.groundFraction();
        upload(earlier.cells(), later.cells());
        follow(environment);
    }

    /** Uploads the cells of two times that are not in the textures yet. */
    private void upload(CellStack from, CellStack to) {
        if (from == densityFrom && to == densityTo) {
            return;
        }
        densityFrom = from;
        densityTo = to;
        if (from != lightOf && from == lightToComeOf) {
            Texture passed = light;
            light = lightToCome;
            lightToCome = passed;
            lightToComeOf = null;
        } else if (from != lightOf) {
            uploadLight(light, from);
        }
        if (to != lightToComeOf && to != from) {
            uploadLight(lightToCome, to);
        }
        uploadDensity(from, to);
        lightOf = from;
        lightToComeOf = to == from ? lightToComeOf : to;
    }

    private void uploadDensity(CellStack from, CellStack to) {
        CellBox cells = from.narrowest();
        ByteBuffer texels = MemoryUtil.memAlloc(4 * cells.nx() * cells.ny());
        for (int box = 0; box < from.levels(); box++) {
            var rows = new Texture.Region(0, box * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                from.putDensity(to, box, k, texels.clear());
                density.upload(k, rows, texels.flip());
            }
        }
        MemoryUtil.memFree(texels);
    }

    private static void uploadLight(Texture texture, CellStack stack) {
        CellBox cells = stack.light().get(0).cells();
        ByteBuffer texels = MemoryUtil.memAlloc(4 * Float.BYTES * cells.nx() * cells.ny());
        for (int box = 0; box < stack.levels(); box++) {
            var rows = new Texture.Region(0, box * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                stack.light().get(box).put(k, texels.clear().asFloatBuffer());
                texture.upload(k, rows, texels.clear());
            }
        }
        MemoryUtil.memFree(texels);
    }

    private void follow(Environment now) {
        if (now == followed) {
            return;
        }
        followed = now;
        Aabb extent = cloud.bounds();
        Sun sun = Daylight.atHeight(now, (extent.minY() + extent.maxY()) / 2);
        SkyIrradiance sky = ambient.clearIrradiance(now);
        around = new OutsideOfCloud(
                CloudTimeline.towardsSun(now),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                Vec3.of(sky.ambient(0, 1, 0)),
                Vec3.of(sky.ambient(0, -1, 0)));
    }

    /** Returns the light around it at the time of the frame. */
    OutsideOfCloud around() {
        return around;
    }

    /** Returns the cloud at the earlier of the two sampled times. */
    public DrawnCloud earlier() {
        return earlier;
    }

    /** Returns the cloud at the later one. */
    public DrawnCloud later() {
        return later;
    }

    /** Returns the fraction of the time between them that has passed, 0 to 1. */
    public double fraction() {
        return fraction;
    }

    /**
     * Binds the textures and sets the uniforms of a program in use.
     *
     * @param focus of the boxes of layers
     */
    public void put(CloudPrograms.Shared uniforms, View view, Vec3 focus) {
        density.bind(TextureUnit.CLOUD_DENSITY);
        light.bind(TextureUnit.CLOUD_LIGHT);
        if (!isSteady) {
            lightToCome.bind(TextureUnit.CLOUD_LIGHT_TO_COME);
        }
        smallAngles.bind(TextureUnit.SMALL_ANGLES);
        put(uniforms.nested(), view.eye().minus(placed.drift()), focus.minus(view.eye()));
        CloudLight physics = cloud.physics();
        DeltaScaling scaled = physics.medium();
        uniforms.medium()
                .set(
                        placed.presence() * earlier.cells().wholePerMetre(),
                        scaled.depthFactor(),
                        physics.optics().albedo(),
                        scaled.albedo());
        uniforms.phase()
                .set(
                        scaled.g(),
                        1 / physics.smallAngles().deepest(),
                        cloud.halfCurvature(),
                        physics.optics().meanCosine());
        uniforms.cloudSun().set(around.towardsSun());
        uniforms.diffuseAxis().set(earlier.cells().diffuseAxis(around.towardsSun()), physics.slopeOfBeam());
        uniforms.irradiance().set(around.irradiance());
        uniforms.skyAbove().set(around.above());
        uniforms.skyBelow().setScaled(around.below(), groundFraction);
    }

    /** Returns the least optical depth from the place where a view begins, the eye or the exit in front of it, to the outside. */
    public double depthAround(View view) {
        Plane exit = view.clip();
        Vec3 begin = exit == null ? view.eye() : exit.nearest(view.eye());
        Vec3 place = begin.minus(placed.drift());
        double before = earlier.cells().leastDepth(place);
        double after = fraction == 0 ? before : later.cells().leastDepth(place);
        return placed.presence() * (before + fraction * (after - before));
    }

    /** Returns the longest path through the cloud; of a layer, which has no end, the greatest float. */
    public double longestPathMetres() {
        Aabb box = earlier.cells().narrowest().box();
        return earlier.cells().isLayer()
                ? Float.MAX_VALUE
                : new Vec3(box.maxX(), box.maxY(), box.maxZ())
                        .minus(new Vec3(box.minX(), box.minY(), box.minZ()))
                        .length();
    }

    private void put(CloudPrograms.Boxes uniforms, Vec3 eye, Vec3 focus) {
        CellStack cells = earlier.cells();
        for (int level = 0; level < cells.levels(); level++) {
            uniforms.put(level, cells.density().get(level).cells().box(), eye);
        }
        CellBox narrowest = cells.narrowest();
        Aabb box = narrowest.box();
        uniforms.cells().set(narrowest.ny(), cells.light().get(0).cells().ny(), cells.levels(), fraction);
        if (cells.isLayer()) {
            uniforms.put(box, eye, focus, cells.reachMetres(), cells.reachMetres());
        } else {
            double halfX = (box.maxX() - box.minX()) / 2;
            uniforms.put(box, eye, box.centre().minus(eye), halfX, (box.maxZ() - box.minZ()) / 2);
        }
    }
}
