package nephele.engine.render.resource;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.DoubleFunction;
import java.util.function.Predicate;
import nephele.engine.render.gl.GlObject;

/**
 * Objects for heights from which views are drawn: those through openings may be at other heights than the eye's. The
 * object that has not been used for longest makes room for a new one.
 */
public final class HeightCache<T extends GlObject> implements GlObject {
    private static final int MOST = 6;
    /** Shelves between an eye and the tables that stand in for its own. */
    private static final double MOST_APART = 2.5;

    private final DoubleFunction<T> make;
    /** In the order of their last use. */
    private final Map<Double, T> objects = new LinkedHashMap<>(16, 0.75f, true);

    /** @param make called with a height, metres */
    public HeightCache(DoubleFunction<T> make) {
        this.make = make;
    }

    /**
     * Returns the height whose tables serve an eye: the ground's air is the same for all eyes up to some metres, and at
     * any height that of eyes within a tenth of it, and within 50 m.
     */
    public static double shelf(double heightMetres) {
        double lowest = 2;
        double wanted = Math.rint(shelvesBelow(Math.max(lowest, heightMetres)));
        double low = lowest;
        double high = Math.min(lowest * Math.exp(wanted / 5), lowest + 100 * wanted);
        for (int i = 0; i < 60 && high > low; i++) {
            double middle = (low + high) / 2;
            if (shelvesBelow(middle) < wanted) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }

    private static double shelvesBelow(double heightMetres) {
        return 5 * Math.log(heightMetres / 2) + (heightMetres - 2) / 100;
    }

    /**
     * Returns the object of an eye's shelf, or while that is being prepared the nearest one of two shelves on either
     * side, so that an eye that rises waits for nothing; without one of these the eye's own, ready or not.
     */
    public T near(double heightMetres, Predicate<T> isReady, Consumer<T> prepare) {
        double place = shelvesBelow(Math.max(2, heightMetres));
        T own = at(shelf(heightMetres));
        if (isReady.test(own)) {
            return own;
        }
        T standIn = null;
        double least = MOST_APART;
        for (Map.Entry<Double, T> entry : objects.entrySet()) {
            double apart = Math.abs(shelvesBelow(entry.getKey()) - place);
            if (apart < least && isReady.test(entry.getValue())) {
                standIn = entry.getValue();
                least = apart;
            }
        }
        if (standIn == null) {
            return own;
        }
        prepare.accept(own);
        return standIn;
    }

    private T at(double heightMetres) {
        T known = objects.get(heightMetres);
        if (known != null) {
            return known;
        }
        if (objects.size() == MOST) {
            Iterator<T> oldest = objects.values().iterator();
            oldest.next().close();
            oldest.remove();
        }
        T made = make.apply(heightMetres);
        objects.put(heightMetres, made);
        return made;
    }

    /** Closes all objects; others are made afterwards. */
    public void clear() {
        objects.values().forEach(GlObject::close);
        objects.clear();
    }

    @Override
    public void close() {
        clear();
    }
}
