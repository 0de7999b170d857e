package nephele.engine.render.pass.cloud.shaft;

import java.nio.ByteBuffer;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.LayerGrid;
import nephele.engine.cloud.cells.SlantedShade;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The shade of clouds at two sampled times on the GPU, the boxes on top of each other. */
final class ShadeTexture {
    private final Texture texture;
    private SlantedShade shownFrom;
    private SlantedShade shownTo;

    ShadeTexture(LoadContext context, LayerGrid grid) {
        CellBox cells = grid.box(0, new LayerGrid.Column(0, 0));
        texture = context.own(new Texture(
                context.gl(),
                "shade of clouds",
                Texture.Shape.VOLUME,
                PixelFormat.RG16,
                new Texture.Extent(cells.nx(), cells.ny() * grid.levels(), cells.nz()),
                Sampling.LINEAR_CLAMP));
    }

    /** Shows the shade between two times; uploads it only when one of them has changed. */
    void show(CloudInterval now) {
        SlantedShade from = now.from().shade();
        SlantedShade to = now.to().shade();
        if (from == shownFrom && to == shownTo) {
            return;
        }
        shownFrom = from;
        shownTo = to;
        CellBox cells = from.boxes().get(0);
        ByteBuffer texels = MemoryUtil.memAlloc(2 * Short.BYTES * cells.nx() * cells.ny());
        for (int level = 0; level < from.boxes().size(); level++) {
            var rows = new Texture.Region(0, level * cells.ny(), cells.nx(), cells.ny());
            for (int k = 0; k < cells.nz(); k++) {
                from.put(to, level, k, texels.clear().asShortBuffer());
                texture.upload(k, rows, texels.clear());
            }
        }
        MemoryUtil.memFree(texels);
    }

    void bind() {
        texture.bind(TextureUnit.SHAFT_SHADE);
    }
}
