package nephele.engine.render.pass.cloud.skyplane;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetPrograms;

/** A cloud of the level that is drawn as a sheet of columns. */
final class SkyplaneCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final LitCloud lit;
    private final ColumnTexture columns;
    private final SheetPrograms<Void> programs;

    SkyplaneCloud(LoadContext context, PlacedCloud placed, SheetPrograms<Void> programs) {
        this.placed = placed;
        this.programs = programs;
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
        programs.use(canvas, placed, lit);
        columns.bind();
        programs.draw();
    }
}
