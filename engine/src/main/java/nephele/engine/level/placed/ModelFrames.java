package nephele.engine.level.placed;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.math.Rotations;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * The frames of models in the world. They have the same bits on every machine, because collision shapes follow from
 * them.
 */
final class ModelFrames {
    private final List<ModelPlacement> models;
    private final Map<String, Integer> indexById = new HashMap<>();
    private final Matrix4d[] worldFromModel;

    private ModelFrames(List<ModelPlacement> models) {
        this.models = models;
        worldFromModel = new Matrix4d[models.size()];
        for (int i = 0; i < models.size(); i++) {
            indexById.put(models.get(i).id(), i);
        }
    }

    /**
     * Returns world-from-model of each model: the parent's frame outermost, then its own steps in order.
     *
     * @throws IllegalArgumentException if a parent is missing or in a cycle; a level rule reports that first
     */
    static List<Matrix4dc> of(List<ModelPlacement> models) {
        ModelFrames frames = new ModelFrames(models);
        for (int i = 0; i < models.size(); i++) {
            frames.find(i);
        }
        return List.copyOf(Arrays.asList(frames.worldFromModel));
    }

    /**
     * Goes up to the nearest ancestor with a frame, then down again, without recursion, so that chains may have any
     * length.
     */
    private void find(int model) {
        Deque<Integer> waiting = new ArrayDeque<>();
        int at = model;
        while (at >= 0 && worldFromModel[at] == null) {
            waiting.push(at);
            at = parent(at);
            if (waiting.size() > models.size()) {
                throw new IllegalArgumentException("'" + models.get(model).id() + "' hangs below itself");
            }
        }
        Matrix4d frame = at < 0 ? new Matrix4d() : worldFromModel[at];
        while (!waiting.isEmpty()) {
            int next = waiting.pop();
            frame = new Matrix4d(frame);
            for (TransformStep step : models.get(next).transform()) {
                apply(step, frame);
            }
            worldFromModel[next] = frame;
        }
    }

    private static void apply(TransformStep step, Matrix4d frame) {
        if (step instanceof Translate translate) {
            frame.translate(
                    translate.by().x(), translate.by().y(), translate.by().z());
        } else if (step instanceof Rotate rotate) {
            frame.rotate(Rotations.aroundAxis(rotate.axis(), StrictMath.toRadians(rotate.angleDegrees())));
        } else if (step instanceof Scale scale) {
            frame.scale(scale.by().x(), scale.by().y(), scale.by().z());
        }
    }

    /** Returns −1 for none. */
    private int parent(int model) {
        String id = models.get(model).parent();
        if (id == null) {
            return -1;
        }
        Integer parent = indexById.get(id);
        if (parent == null) {
            throw new IllegalArgumentException("there is no model '" + id + "'");
        }
        return parent;
    }
}
