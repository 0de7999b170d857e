package nephele.engine.render.pass.cloud.skyplane;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.SheetColumns;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPrograms;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import org.lwjgl.system.MemoryUtil;

/** Draws a cloud as a sheet at the middle of its heights, by the optical depths of its columns. */
public final class SkyplaneTechnique implements CloudDrawing {
    public static final Technique REGISTERED =
            new Technique(CloudTechnique.SKYPLANE, cloud -> true, SkyplaneTechnique::new);

    private final PlacedCloud placed;
    private final LitCloud lit;
    /** The columns of the cloud's boxes at two sampled times: two layers for each box. */
    private final Texture columns;

    private final CloudPrograms<SheetUniforms> programs;
    private final FullScreenTriangle triangle;
    private List<CloudSource.Box> columnsFrom;
    private List<CloudSource.Box> columnsTo;

    private record SheetUniforms(CloudPrograms.Shared cloud, Vector2 sheet) {}

    private SkyplaneTechnique(CloudContext context, PlacedCloud placed) {
        this.placed = placed;
        lit = new LitCloud(context.load(), placed);
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "skyplane"));
        boolean isOctaves = context.load().quality().cloudScattering() == CloudScattering.OCTAVES;
        String shape = "SHEET_" + context.load().quality().skyplaneShape().name();
        programs = new CloudPrograms<>(
                context,
                "cloud.vert",
                "skyplane/skyplane.frag",
                defines -> lit.define(defines).withIf(isOctaves, "OCTAVES").with(shape),
                SheetUniforms.class);
        CellBox cells = placed.source().narrowest();
        columns = context.load()
                .own(new Texture(
                        context.load().gl(),
                        "cloud columns",
                        Texture.Shape.ARRAY,
                        PixelFormat.RGBA32F,
                        new Texture.Extent(
                                SheetColumns.PER_CELL * cells.nx(),
                                SheetColumns.PER_CELL * cells.nz(),
                                2 * placed.source().levels()),
                        Sampling.LINEAR_CLAMP));
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
        List<CloudSource.Box> from = lit.earlier().boxes();
        List<CloudSource.Box> to = lit.later().boxes();
        if (from == columnsFrom && to == columnsTo) {
            return;
        }
        columnsFrom = from;
        columnsTo = to;
        upload(from, 0);
        if (to != from) {
            upload(to, 1);
        }
    }

    private void upload(List<CloudSource.Box> boxes, int time) {
        ByteBuffer texels =
                MemoryUtil.memAlloc(Float.BYTES * boxes.get(0).columns().values().length);
        for (int box = 0; box < boxes.size(); box++) {
            texels.clear().asFloatBuffer().put(boxes.get(box).columns().values());
            columns.upload(2 * box + time, texels.clear());
        }
        MemoryUtil.memFree(texels);
    }

    @Override
    public void draw(CloudCanvas canvas) {
        SheetUniforms uniforms = programs.use(canvas.pixels());
        canvas.put(uniforms.cloud, placed);
        lit.put(uniforms.cloud, canvas.view(), canvas.focus());
        uniforms.sheet.set(canvas.view().eyeY(), lit.longestPathMetres());
        columns.bind(TextureUnit.CLOUD_COLUMNS);
        triangle.draw();
    }
}
