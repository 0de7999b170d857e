package nephele.engine.render.pass.cloud.shade;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import nephele.engine.cloud.drawn.DrawnClouds;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.CloudShadeRegion;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import org.lwjgl.system.MemoryUtil;

/** Publishes the shade of clouds on the level, computed when the clouds or the sun have moved. */
public final class CloudShadePass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("cloud.shade", Stage.ONCE_A_FRAME, CloudShadePass::requiredBy);

    private static final int ACROSS = 48;
    private static final int LAYERS = 6;

    private final SharedResources shared;
    private final Aabb region;
    private final Texture texture;
    private DrawnClouds shown;

    private CloudShadePass(LoadContext context) {
        shared = context.shared();
        region = CloudShadeRegion.of(context.scene().statics());
        texture = context.own(new Texture(
                context.gl(),
                "cloud shade",
                Texture.Shape.VOLUME,
                PixelFormat.R16,
                new Texture.Extent(ACROSS, LAYERS, ACROSS),
                Sampling.LINEAR_CLAMP));
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.CLOUD_SHADE)
                ? List.of(new Required("environment.clouds: they dim the sun on surfaces", CloudShadePass::new))
                : List.of();
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.CLOUD_SHADE);
    }

    @Override
    public void draw(FrameContext frame) {
        if (shared.clouds() != shown) {
            shown = shared.clouds();
            upload();
        }
        shared.publish(Target.CLOUD_SHADE, texture);
    }

    private void upload() {
        short[] shares = new short[ACROSS * LAYERS * ACROSS];
        IntStream.range(0, ACROSS).parallel().forEach(k -> {
            for (int at = 0; at < ACROSS * LAYERS; at++) {
                Vec3 place = new Vec3(
                        between(region.minX(), region.maxX(), at % ACROSS, ACROSS),
                        between(region.minY(), region.maxY(), at / ACROSS, LAYERS),
                        between(region.minZ(), region.maxZ(), k, ACROSS));
                shares[k * ACROSS * LAYERS + at] = (short) Math.round(65535 * shown.sunShare(place));
            }
        });
        ByteBuffer slice = MemoryUtil.memAlloc(Short.BYTES * ACROSS * LAYERS);
        for (int k = 0; k < ACROSS; k++) {
            slice.clear().asShortBuffer().put(shares, k * ACROSS * LAYERS, ACROSS * LAYERS);
            texture.upload(k, slice.clear());
        }
        MemoryUtil.memFree(slice);
    }

    private static double between(double min, double max, int index, int count) {
        return min + (index + 0.5) / count * (max - min);
    }
}
