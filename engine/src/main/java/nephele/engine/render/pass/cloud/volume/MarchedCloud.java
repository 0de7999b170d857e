package nephele.engine.render.pass.cloud.volume;

import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PerPixels;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;
import nephele.engine.scene.View;

/** A cloud of the level whose cells are marched. */
final class MarchedCloud implements CloudDrawing {
    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final LitCloud lit;
    private final PerPixels<MarchPrograms> programs;
    private final FullScreenTriangle triangle;
    private final double stepCells;
    /** {@code null} if the density comes from cells. */
    private final NoiseTextures noiseTextures;

    /** Its noise at the time; {@code null} if the density comes from cells. */
    private NoiseField noise;

    MarchedCloud(
            LoadContext context, PlacedCloud placed, PerPixels<MarchPrograms> programs, FullScreenTriangle triangle) {
        this.placed = placed;
        this.programs = programs;
        this.triangle = triangle;
        cloud = placed.source();
        lit = new LitCloud(context, placed);
        stepCells = context.quality().cloudStep();
        noiseTextures = cloud.isProfiled()
                ? new NoiseTextures(context, (ProfiledNoise) cloud.noise(0).density(), cloud.levels())
                : null;
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
        if (noiseTextures != null) {
            noise = cloud.noise(cloud.evolves() ? now.seconds() : 0);
            noiseTextures.show(lit.shown().plans(), lit.toCome().plans());
        }
    }

    @Override
    public void draw(CloudCanvas canvas) {
        MarchProgram program = programs.of(canvas.pixels()).of(kind());
        program.use();
        canvas.put(program.pixels(), placed);
        bind(program, canvas.view(), canvas.focus());
        triangle.draw();
    }

    private Noise kind() {
        return !cloud.isProfiled() ? Noise.NONE : cloud.evolves() ? Noise.EVOLVING : Noise.STILL;
    }

    /** @param focus of the boxes of layers */
    private void bind(MarchProgram program, View view, Vec3 focus) {
        boolean isLook = program.cells() != null;
        if (isLook) {
            lit.put(program.cells(), view, focus);
        } else {
            lit.put(program.density(), view, focus);
        }
        if (noiseTextures != null) {
            noiseTextures.bind(program.noisePlaces(), noise, view.eye().minus(placed.drift()));
        }
        MarchProgram.Places places = program.places();
        CellBox narrowest = lit.shown().cells().narrowest();
        places.cellEdges().set((float) narrowest.sizeX(), (float) narrowest.sizeY(), (float) narrowest.sizeZ(), (float)
                narrowest.shortest());
        places.stepping()
                .set((float) stepCells, 0.5f, (float) view.eyeY(), (float) (isLook ? lit.depthAround(view) : 0));
    }
}
