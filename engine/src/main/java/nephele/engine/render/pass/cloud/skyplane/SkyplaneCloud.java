package nephele.engine.render.pass.cloud.skyplane;

import java.util.function.Function;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetProgram;

/** A cloud of the level that is drawn as a sheet of columns. */
final class SkyplaneCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final LitCloud lit;
    private final ColumnTexture columns;
    private final Function<CloudPixels, SheetProgram<Void>> programs;
    private final FullScreenTriangle triangle;

    SkyplaneCloud(
            LoadContext context,
            PlacedCloud placed,
            Function<CloudPixels, SheetProgram<Void>> programs,
            FullScreenTriangle triangle) {
        this.placed = placed;
        this.programs = programs;
        this.triangle = triangle;
        lit = new LitCloud(context, placed);
        columns = new ColumnTexture(context, placed.source());
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
        columns.show(lit.shown().sheet(), lit.toCome().sheet());
    }

    @Override
    public void draw(CloudCanvas canvas) {
        programs.apply(canvas.pixels()).use(canvas, placed, lit);
        columns.bind();
        triangle.draw();
    }
}
