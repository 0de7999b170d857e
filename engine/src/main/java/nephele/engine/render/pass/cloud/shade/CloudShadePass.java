package nephele.engine.render.pass.cloud.shade;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.SunThroughClouds;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.FrameClouds;
import nephele.engine.render.resource.RendererClouds;
import org.lwjgl.system.MemoryUtil;

/** Publishes the shade of clouds on the level. */
public final class CloudShadePass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "cloud.shade", Stage.ONCE_A_FRAME, CloudShadePass::requiredBy)
            .using(RendererClouds.RESOURCE);

    private final RendererClouds clouds;
    private final Map<Target, Texture> targets;
    private final CellBox lattice;
    private final Texture texture;
    private CloudInterval uploaded;

    private CloudShadePass(LoadContext context) {
        clouds = context.get(RendererClouds.RESOURCE);
        targets = context.targets();
        lattice =
                SunThroughClouds.lattice(FrameClouds.shadeRegion(context.scene().statics()));
        texture = context.own(new Texture(
                context.gl(),
                "cloud shade",
                Texture.Shape.VOLUME,
                PixelFormat.R16,
                new Texture.Extent(lattice.nx(), lattice.ny(), lattice.nz()),
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
        CloudInterval now = clouds.current().now();
        if (now == null) {
            uploadFull();
        } else if (uploaded == null || now.from() != uploaded.from() || now.fraction() != uploaded.fraction()) {
            uploaded = now;
            upload();
        }
        targets.put(Target.CLOUD_SHADE, texture);
    }

    /** Leaves the sun all its light: no cloud has any extinction. */
    private void uploadFull() {
        ByteBuffer slice = MemoryUtil.memAlloc(Short.BYTES * lattice.nx() * lattice.ny());
        MemoryUtil.memSet(slice, 0xff);
        for (int k = 0; k < lattice.nz(); k++) {
            texture.upload(k, slice.clear());
        }
        MemoryUtil.memFree(slice);
    }

    private void upload() {
        ByteBuffer slice = MemoryUtil.memAlloc(Short.BYTES * lattice.nx() * lattice.ny());
        for (int k = 0; k < lattice.nz(); k++) {
            uploaded.from()
                    .sun()
                    .put(
                            uploaded.to().sun(),
                            uploaded.fraction(),
                            k,
                            slice.clear().asShortBuffer());
            texture.upload(k, slice.clear());
        }
        MemoryUtil.memFree(slice);
    }
}
