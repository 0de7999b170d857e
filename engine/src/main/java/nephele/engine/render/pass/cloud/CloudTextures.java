package nephele.engine.render.pass.cloud;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.CellTexels;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.light.SmallAngleScattering;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The cells of a cloud at two sampled times on the GPU, as {@code cloud-march.glsl} reads them. */
public final class CloudTextures {
    private final Texture density;
    private final Texture smallAngles;
    private Texture last;
    private Texture next;
    /** The cells whose light {@link #last} holds, then those of {@link #next}. */
    private CellStack lastShown;

    private CellStack nextShown;
    /** The cells whose densities are shown. */
    private CellStack shownFrom;

    private CellStack shownTo;

    public CloudTextures(LoadContext context, CloudSource cloud) {
        CellBox cells = cloud.narrowest();
        density = volume(context, "cloud density", PixelFormat.RGBA8, cells, cloud.levels());
        CellBox lit = cells.coarser(context.quality().cloudLightCell());
        last = volume(context, "cloud light", PixelFormat.RGBA16F, lit, cloud.levels());
        next = volume(context, "cloud light to come", PixelFormat.RGBA16F, lit, cloud.levels());
        smallAngles = context.own(new Texture(
                context.gl(),
                "small-angle scattering",
                Texture.Shape.FLAT,
                PixelFormat.R32F,
                Texture.Extent.flat(SmallAngleScattering.SEPARATIONS, SmallAngleScattering.DEPTHS),
                Sampling.LINEAR_CLAMP));
        uploadSmallAngles(cloud.physics().smallAngles().values());
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

    private void uploadSmallAngles(float[] values) {
        FloatBuffer texels = MemoryUtil.memAllocFloat(values.length);
        texels.put(values).flip();
        smallAngles.upload(0, MemoryUtil.memByteBuffer(texels));
        MemoryUtil.memFree(texels);
    }

    /** Shows the cells of two times; uploads only what is not there yet. */
    public void show(CellStack from, CellStack to) {
        if (from == shownFrom && to == shownTo) {
            return;
        }
        shownFrom = from;
        shownTo = to;
        if (from != lastShown && from == nextShown) {
            Texture passed = last;
            last = next;
            next = passed;
            nextShown = null;
        } else if (from != lastShown) {
            uploadLight(last, from);
        }
        if (to != nextShown && to != from) {
            uploadLight(next, to);
        }
        uploadDensity(from, to);
        lastShown = from;
        nextShown = to == from ? nextShown : to;
    }

    private void uploadDensity(CellStack from, CellStack to) {
        CellBox cells = from.narrowest();
        ByteBuffer texels = MemoryUtil.memAlloc(4 * cells.nx() * cells.ny());
        for (int box = 0; box < from.levels(); box++) {
            var rows = new Texture.Region(0, box * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                CellTexels.putDensity(from, to, box, k, texels.clear());
                density.upload(k, rows, texels.flip());
            }
        }
        MemoryUtil.memFree(texels);
    }

    private static void uploadLight(Texture light, CellStack cloud) {
        CellBox cells = cloud.light().get(0).cells();
        ByteBuffer texels = MemoryUtil.memAlloc(4 * Float.BYTES * cells.nx() * cells.ny());
        for (int box = 0; box < cloud.levels(); box++) {
            var rows = new Texture.Region(0, box * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                CellTexels.putLight(cloud.light().get(box), k, texels.clear().asFloatBuffer());
                light.upload(k, rows, texels.clear());
            }
        }
        MemoryUtil.memFree(texels);
    }

    public void bind() {
        density.bind(TextureUnit.CLOUD_DENSITY);
        last.bind(TextureUnit.CLOUD_LIGHT);
        next.bind(TextureUnit.CLOUD_LIGHT_TO_COME);
        smallAngles.bind(TextureUnit.SMALL_ANGLES);
    }
}
