package nephele.scenes.fixed;

import nephele.engine.math.Frustum;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Texture;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.ModelOrder.Motion;
import nephele.scenes.xml.PosedScene;
import org.joml.Matrix4dc;

/** One scene's models with their lights. */
final class SceneOnGpu implements AutoCloseable {
    private final PosedScene posed;
    private final LightChains lights;
    private final FixedModels models;

    private SceneOnGpu(GlContext gl, Source source, Motion least, Texture white, PosedScene around) {
        posed = PosedScene.of(source.scene());
        lights = new LightChains(gl, posed, around);
        models = new FixedModels(gl, posed, ModelOrder.of(posed, source.files(), least), white, lights);
    }

    static SceneOnGpu atHome(GlContext gl, Source source, Texture white) {
        return new SceneOnGpu(gl, source, Motion.STAYS, white, null);
    }

    /** @param around the surrounding scene */
    static SceneOnGpu entity(GlContext gl, Source source, Texture white, SceneOnGpu around) {
        return new SceneOnGpu(gl, source, Motion.MOVES, white, around.posed);
    }

    void pose(double seconds, Matrix4dc worldFromScene) {
        posed.at(seconds);
        models.update(worldFromScene);
        lights.update(worldFromScene);
    }

    void draw(FixedProgram.Inputs inputs, Frustum frustum) {
        if (inputs.light() != null) {
            lights.bind();
        }
        models.draw(inputs, frustum);
    }

    @Override
    public void close() {
        models.close();
        lights.close();
    }
}
