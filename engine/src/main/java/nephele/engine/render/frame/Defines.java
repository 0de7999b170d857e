package nephele.engine.render.frame;

import java.util.HashMap;
import java.util.Map;
import nephele.engine.scene.ViewTree;

/** The preprocessor names that a pass compiles its shaders with. */
public final class Defines {
    private final Map<String, String> values = new HashMap<>();

    /** Output and tone curve of {@code context}, which {@code output.glsl} needs, and whether there may be portals. */
    public static Defines of(LoadContext context) {
        return new Defines()
                .with(context.output().define())
                .with(Development.define(context.scene().level().environment().toneCurve()))
                .withIf(ViewTree.mayGrow(context.scene().level()), "PORTALS");
    }

    public Defines with(String name) {
        return with(name, 1);
    }

    public Defines with(String name, int value) {
        values.put(name, Integer.toString(value));
        return this;
    }

    public Defines withIf(boolean wanted, String name) {
        return wanted ? with(name) : this;
    }

    public Map<String, String> values() {
        return Map.copyOf(values);
    }
}
