package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.View;

/**
 * The shared resources of one renderer, each made when it is first asked for and closed with the renderer, the last
 * first. Frames and views reach them in the order in which they were made: each after those that it was made from.
 */
public final class RenderResources implements GlObject {
    private final LoadContext context;
    private final FrameEnvironment environment;
    private final Map<SharedResource<?>, Object> made = new HashMap<>();
    private final List<Consumer<FrameContext>> followers = new ArrayList<>();
    private final List<Consumer<View>> inViews = new ArrayList<>();
    private FrameUniforms uniforms;
    private double acrossShift;
    private double upShift;
    private RenderResources replaced;

    /**
     * @param owned closed with these
     * @param replaced those of a renderer from whose level this one is edited; {@code null} without one
     */
    public RenderResources(OwnedObjects owned, DrawnScene drawn, FrameRequest request, RenderResources replaced) {
        Map<Target, Texture> targets = new EnumMap<>(Target.class);
        context = new LoadContext(owned.gl(), drawn, request, this, targets, owned, null);
        environment = new FrameEnvironment(request.output());
        this.replaced = replaced;
    }

    /** Returns the arguments for building the passes of a feature. */
    public LoadContext context(RenderFeature feature) {
        return new LoadContext(
                context.gl(), context.drawn(), context.request(), this, context.targets(), context.owner(), feature);
    }

    public FrameRequest request() {
        return context.request();
    }

    /** Returns the textures that passes write for later ones. */
    public Map<Target, Texture> targets() {
        return context.targets();
    }

    /** Returns a shared object, {@code null} if the level has none. */
    public <T> T get(SharedResource<T> resource) {
        if (!made.containsKey(resource)) {
            T object = resource.make().apply(context);
            made.put(resource, object);
            if (object != null) {
                add(object, resource.follow(), followers);
                add(object, resource.setView(), inViews);
            }
        }
        return ifMade(resource);
    }

    private static <T, A> void add(T object, BiConsumer<T, A> update, List<Consumer<A>> updates) {
        if (update != null) {
            updates.add(argument -> update.accept(object, argument));
        }
    }

    /** Returns a shared object, {@code null} if nothing has asked for it. */
    @SuppressWarnings("unchecked")
    public <T> T ifMade(SharedResource<T> resource) {
        return (T) made.get(resource);
    }

    /** Returns the object of the renderer that this one replaces, {@code null} if it has none; only while passes are built. */
    public <T> T replaced(SharedResource<T> resource) {
        return replaced == null ? null : replaced.ifMade(resource);
    }

    /** Ends the building of passes. */
    public void forgetReplaced() {
        replaced = null;
    }

    /** Returns the values that follow from the environment of a frame. */
    public FrameEnvironment environment() {
        return environment;
    }

    /** Returns the block of {@code frame.glsl}, bound at {@link nephele.engine.render.gl.shader.UniformBlock#FRAME}. */
    public FrameUniforms uniforms() {
        if (uniforms == null) {
            uniforms = context.own(
                    new FrameUniforms(context.gl(), context.scene().level().environment()));
        }
        return uniforms;
    }

    /** Begins a frame. */
    public void follow(FrameContext frame) {
        environment.follow(frame.frameState().environment());
        for (int i = 0; i < followers.size(); i++) {
            followers.get(i).accept(frame);
        }
    }

    /** Moves all views of the frame in the picture, by halves of its width and height. */
    public void shift(double across, double up) {
        acrossShift = across;
        upShift = up;
    }

    /** Sets the view of the following draws. */
    public void setView(View view) {
        for (int i = 0; i < inViews.size(); i++) {
            inViews.get(i).accept(view);
        }
        resume(view);
    }

    /** Sets the numbers of the current view again after those of another one were drawn with. */
    public void resume(View view) {
        uniforms().upload(view, environment.exposure(), acrossShift, upShift);
    }

    @Override
    public void close() {
        context.owner().close();
    }
}
