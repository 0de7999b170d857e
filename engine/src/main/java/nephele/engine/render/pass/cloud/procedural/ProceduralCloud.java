package nephele.engine.render.pass.cloud.procedural;

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

/** A cloud of the level that is drawn as a sheet of octaves. */
final class ProceduralCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final LitCloud lit;
    private final Function<CloudPixels, SheetProgram<OctaveUniforms>> programs;
    private final FullScreenTriangle triangle;

    ProceduralCloud(
            LoadContext context,
            PlacedCloud placed,
            Function<CloudPixels, SheetProgram<OctaveUniforms>> programs,
            FullScreenTriangle triangle) {
        this.placed = placed;
        this.programs = programs;
        this.triangle = triangle;
        lit = new LitCloud(context, placed);
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
    }

    @Override
    public void draw(CloudCanvas canvas) {
        OctaveUniforms octaves = programs.apply(canvas.pixels()).use(canvas, placed, lit);
        octaves.put(placed.source().sheet(), canvas.view().eye().minus(placed.drift()), placed.seconds());
        triangle.draw();
    }
}
