package nephele.engine.render.pass.cloud.skyplane;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.SheetColumns;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The columns of a cloud's boxes at two sampled times: two layers for each box. */
final class ColumnTexture {
    private final Texture columns;
    private List<SheetColumns> shownFrom;
    private List<SheetColumns> shownTo;

    ColumnTexture(LoadContext context, CloudSource cloud) {
        CellBox cells = cloud.narrowest();
        columns = context.own(new Texture(
                context.gl(),
                "cloud columns",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA32F,
                new Texture.Extent(
                        SheetColumns.PER_CELL * cells.nx(), SheetColumns.PER_CELL * cells.nz(), 2 * cloud.levels()),
                Sampling.LINEAR_CLAMP));
    }

    void show(List<SheetColumns> from, List<SheetColumns> to) {
        if (from == shownFrom && to == shownTo) {
            return;
        }
        shownFrom = from;
        shownTo = to;
        upload(from, 0);
        if (to != from) {
            upload(to, 1);
        }
    }

    private void upload(List<SheetColumns> boxes, int time) {
        ByteBuffer texels = MemoryUtil.memAlloc(Float.BYTES * boxes.get(0).values().length);
        for (int box = 0; box < boxes.size(); box++) {
            texels.clear().asFloatBuffer().put(boxes.get(box).values());
            columns.upload(2 * box + time, texels.clear());
        }
        MemoryUtil.memFree(texels);
    }

    void bind() {
        columns.bind(TextureUnit.CLOUD_COLUMNS);
    }
}
