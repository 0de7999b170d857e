package nephele.engine.render.pass.lightning;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import nephele.engine.lightning.Bolt;
import nephele.engine.lightning.LevelLightning;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * The lines of a bolt: each segment is a rectangle of pixels around it, in which it is spread by a disc. The channel is
 * spread over little more than a pixel, or over its width where that is more; small shares of its light are spread
 * widely, as in an eye or a lens.
 */
final class BoltProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/lightning/";
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT2);
    private static final float[] CORNERS = {-1, -1, 1, -1, 1, 1, -1, 1};
    private static final int[] TRIANGLES = {0, 1, 2, 2, 3, 0};

    /** Share of a bolt's light that comes from the channel itself; clouds around it scatter most of the rest. */
    private static final double SEEN_SHARE = 0.1;

    /** Points of the main channel from one to the next where it is spread widely. */
    private static final int COARSE = 8;

    /**
     * A share of the light.
     *
     * @param radius over which it is spread, as a share of the picture's height; 0 for that of the channel
     */
    private record Spread(double share, double radius) {}

    private static final Spread CHANNEL = new Spread(0.9, 0);
    private static final Spread[] GLARE = {new Spread(0.06, 0.011), new Spread(0.04, 0.05)};

    private final GlProgram<Places> program;
    private final GpuMesh quads;

    private record Places(
            Uniforms.Vector3 boltFromEye,
            Uniforms.Vector3 intensityPerMetre,
            Uniforms.Vector3 brightness,
            Uniforms.Vector3 spreading,
            Uniforms.Vector2 halfPicture) {}

    BoltProgram(LoadContext context, boolean behindClouds) {
        var defines = Defines.of(context).withIf(behindClouds, "CLOUDS").values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "bolt.vert", defines),
                ShaderSource.load(FOLDER + "bolt.frag", defines),
                uniforms -> {
                    MeteredExposure.tieInView(context, uniforms);
                    uniforms.sampler("boltPoints", TextureUnit.BOLT_POINTS);
                    if (behindClouds) {
                        uniforms.sampler("boltTransmittance", TextureUnit.BOLT_TRANSMITTANCE);
                    }
                    return new Places(
                            uniforms.vector3("boltFromEye"),
                            uniforms.vector3("intensityPerMetre"),
                            uniforms.vector3("brightness"),
                            uniforms.vector3("spreading"),
                            uniforms.vector2("halfPicture"));
                });
        quads = context.own(quads(context));
    }

    private static GpuMesh quads(LoadContext context) {
        ByteBuffer corners = MemoryUtil.memAlloc(Bolt.MOST_POINTS * 4 * FORMAT.strideBytes());
        IntBuffer triangles = MemoryUtil.memAllocInt(Bolt.MOST_POINTS * TRIANGLES.length);
        try {
            for (int quad = 0; quad < Bolt.MOST_POINTS; quad++) {
                for (float corner : CORNERS) {
                    corners.putFloat(corner);
                }
                for (int corner : TRIANGLES) {
                    triangles.put(4 * quad + corner);
                }
            }
            return new GpuMesh(context.gl(), "segments of a bolt", FORMAT, corners.flip(), triangles.flip());
        } finally {
            MemoryUtil.memFree(corners);
            MemoryUtil.memFree(triangles);
        }
    }

    /** Draws the bolt of the frame. */
    void draw(FrameContext frame, FrameLightning lightning) {
        program.use();
        lightning.bindPoints(TextureUnit.BOLT_POINTS);
        put(frame, lightning.lightning());
        draw(frame, CHANNEL, 1, lightning.lightning().bolt().points() - 1);
        for (Spread glare : GLARE) {
            draw(frame, glare, COARSE, Bolt.MAIN_SEGMENTS / COARSE);
        }
    }

    private void put(FrameContext frame, LevelLightning lightning) {
        View view = frame.view();
        Bolt bolt = lightning.bolt();
        Places places = program.uniforms();
        Vec3 from = bolt.origin().minus(view.eye());
        places.boltFromEye.set((float) from.x(), (float) from.y(), (float) from.z());
        Vec3 perMetre = lightning.lightning().radiantIntensity().scaled(SEEN_SHARE / Math.max(1, bolt.lengthMetres()));
        places.intensityPerMetre.set((float) perMetre.x(), (float) perMetre.y(), (float) perMetre.z());
        places.halfPicture.set(frame.surface().width() / 2f, frame.surface().height() / 2f);
        double pixel = 2 * view.projection().tanHalfHeight() / frame.surface().height();
        places.brightness.set((float) lightning.brightness(), (float) lightning.branchBrightness(), (float) pixel);
    }

    private void draw(FrameContext frame, Spread spread, int step, int segments) {
        int height = frame.surface().height();
        program.uniforms().spreading.set((float) spread.share, (float) (spread.radius * height), step);
        quads.drawInstanced(0, TRIANGLES.length * segments, 1);
    }
}
