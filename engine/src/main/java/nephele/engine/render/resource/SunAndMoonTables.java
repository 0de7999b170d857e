package nephele.engine.render.resource;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.function.DoubleFunction;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;

/** Tables of the light that the air scatters, as seen from a height: the sun's and the moon's, one texture. */
public final class SunAndMoonTables implements GlObject {
    /** Threads of one renderer that compute tables beside its frames, on all processors but one. They end with it. */
    public static final SharedResource<ForkJoinPool> THREADS = SharedResource.of("threads", SunAndMoonTables::threads);

    /** Simulated time by which the moon's table is begun before the moon gives light. */
    private static final double AHEAD_SECONDS = 1;

    private final double heightMetres;
    private final Texture texture;
    private final MovingTable sun;
    private final MovingTable moon;

    /**
     * @param texture the first half of its layers is the sun's, the second the moon's; closed with this object
     * @param make computes the RGBA texels of one half from the sine of the light's elevation
     */
    public SunAndMoonTables(Texture texture, ForkJoinPool threads, double heightMetres, DoubleFunction<float[]> make) {
        this.heightMetres = heightMetres;
        this.texture = texture;
        int half = texture.extent().layers() / 2;
        sun = new MovingTable(texture, 0, half, threads, make);
        moon = new MovingTable(texture, half, half, threads, make);
    }

    private static ForkJoinPool threads(LoadContext context) {
        ForkJoinPool threads = new ForkJoinPool(
                Math.max(1, Runtime.getRuntime().availableProcessors() - 1),
                pool -> {
                    ForkJoinWorkerThread thread = ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
                    thread.setName("nephele-tables-" + thread.getPoolIndex());
                    return thread;
                },
                null,
                false);
        context.own(threads::shutdownNow);
        return threads;
    }

    /** Returns true if no table of a light that shines has to be waited for. */
    public boolean isReady(SunAndMoon lights) {
        boolean isSunReady = sun.isReady(lights.towardsSun().y(), lights.move());
        return isSunReady
                && (!lights.moonlight().shines()
                        || moon.isReady(lights.moonlight().towardsMoon().y(), lights.move()));
    }

    /** Computes the tables that are missing beside the frames. */
    public void prepare(SunAndMoon lights) {
        sun.prepare(lights.towardsSun().y());
        if (lights.moonlight().shines()) {
            moon.prepare(lights.moonlight().towardsMoon().y());
        }
    }

    /** Shows the lights; tables of lights that stand still are waited for, as are those of the first frame. */
    public void show(SunAndMoon lights) {
        double sunSine = lights.towardsSun().y();
        double moonSine = lights.moonlight().towardsMoon().y();
        if (!lights.move()) {
            sun.show(sunSine);
            if (lights.moonlight().shines()) {
                moon.show(moonSine);
            }
            return;
        }
        sun.follow(sunSine, lights::sunSineAfter);
        if (lights.moonlight().shines()) {
            moon.follow(moonSine, lights::moonSineAfter);
        } else if (lights.moonShinesAfter(AHEAD_SECONDS)) {
            moon.prepare(moonSine);
        }
    }

    /** Returns the height of the eye for which the tables are. */
    public double heightMetres() {
        return heightMetres;
    }

    public void bind(TextureUnit unit) {
        texture.bind(unit);
    }

    @Override
    public void close() {
        texture.close();
    }
}
