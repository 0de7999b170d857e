package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4dc;

/**
 * A scene's models and lights in one list each, with their poses at a time. Models are in document order, those of a
 * group before those of its subgroups. The lights that reach a model are a chain: {@link #firstLight}, then {@link
 * #nextLight} until {@link #NONE}; groups of any depth share what they inherit.
 */
public final class PosedScene {
    public static final int NONE = -1;

    private final List<StepFrames> frames = new ArrayList<>();
    private final List<Placed<XmlModel>> models = new ArrayList<>();
    private final List<Placed<XmlLight>> lights = new ArrayList<>();
    private double seconds;

    /**
     * An object in a frame. @param light the first light that reaches a model; the next one of the chain for a light
     */
    private record Placed<T>(T what, StepFrames frame, int light) {}

    /** A group in the queue, with its inherited data. */
    private record Waiting(XmlGroup group, StepFrames frame, int lights) {}

    private PosedScene(XmlScene scene) {
        StepFrames world = new StepFrames(null, List.of());
        int lit = addLights(scene.lights(), world, NONE);
        List<Waiting> waiting = new ArrayList<>();
        waiting.add(new Waiting(scene.root(), world, lit));
        while (!waiting.isEmpty()) {
            Waiting next = waiting.remove(waiting.size() - 1);
            XmlGroup group = next.group;
            StepFrames frame = group.steps().isEmpty() ? next.frame : frame(next.frame, group);
            int chain = addLights(group.lights(), frame, next.lights);
            group.models().forEach(model -> models.add(new Placed<>(model, frame, chain)));
            for (int i = group.groups().size() - 1; i >= 0; i--) {
                waiting.add(new Waiting(group.groups().get(i), frame, chain));
            }
        }
    }

    /** Returns the scene at time 0. */
    public static PosedScene of(XmlScene scene) {
        PosedScene posed = new PosedScene(scene);
        posed.frames.forEach(frame -> frame.at(0));
        return posed;
    }

    private StepFrames frame(StepFrames parent, XmlGroup group) {
        StepFrames frame = new StepFrames(parent, group.steps());
        frames.add(frame);
        return frame;
    }

    private int addLights(List<XmlLight> added, StepFrames frame, int last) {
        int before = last;
        for (XmlLight light : added) {
            lights.add(new Placed<>(light, frame, before));
            before = lights.size() - 1;
        }
        return before;
    }

    /** Computes all poses that change with time. Allocates nothing. @param newSeconds finite */
    public void at(double newSeconds) {
        if (!Double.isFinite(newSeconds)) {
            throw new IllegalArgumentException("the time " + newSeconds + " is not finite");
        }
        if (newSeconds == seconds) {
            return;
        }
        seconds = newSeconds;
        // Parents precede their content.
        for (int i = 0; i < frames.size(); i++) {
            if (frames.get(i).moves()) {
                frames.get(i).at(seconds);
            }
        }
    }

    /** Returns the number of models. */
    public int modelCount() {
        return models.size();
    }

    /** Returns a model by its number, from 0. */
    public XmlModel model(int number) {
        return models.get(number).what;
    }

    /** Returns true if the model's pose may change with time. */
    public boolean moves(int model) {
        return models.get(model).frame.moves();
    }

    /** Returns the pose of the last {@link #at}: the same object with a new value. Not finite if the steps overflow. */
    public Matrix4dc worldFromModel(int model) {
        return models.get(model).frame.worldFromGroup();
    }

    /** Returns the first light of the chain of those that reach a model, or {@link #NONE}. */
    public int firstLight(int model) {
        return models.get(model).light;
    }

    public int lightCount() {
        return lights.size();
    }

    public XmlLight light(int number) {
        return lights.get(number).what;
    }

    /** Returns the frame of {@link #light}; behaves as {@link #worldFromModel}. */
    public Matrix4dc worldFromLight(int light) {
        return lights.get(light).frame.worldFromGroup();
    }

    /** Returns the next light of a chain, or {@link #NONE}. */
    public int nextLight(int light) {
        return lights.get(light).light;
    }
}
