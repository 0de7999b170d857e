package nephele.engine.render.pass.cloud.procedural;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetPrograms;

/** A cloud of the level that is drawn as a sheet of octaves. */
final class ProceduralCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final LitCloud lit;
    private final SheetPrograms<OctaveUniforms> programs;

    ProceduralCloud(LoadContext context, PlacedCloud placed, SheetPrograms<OctaveUniforms> programs) {
        this.placed = placed;
        this.programs = programs;
        lit = new LitCloud(context, placed);
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
    }

    @Override
    public void draw(CloudCanvas canvas) {
        OctaveUniforms octaves = programs.use(canvas, placed, lit);
        octaves.put(placed.source().sheet(), canvas.view().eye().minus(placed.drift()), placed.seconds());
        programs.draw();
    }
}
