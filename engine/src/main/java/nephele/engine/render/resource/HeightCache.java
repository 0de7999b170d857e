package nephele.engine.render.resource;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoubleFunction;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.render.gl.GlObject;

/**
 * The tables for heights from which views are drawn: those through openings may be at other heights than the eye's. The
 * tables that have not been used for longest make room for new ones.
 */
public final class HeightCache implements GlObject {
    private static final int MOST = 6;
    /** Shelves between an eye and the tables that stand in for its own. */
    private static final double MOST_APART = 2.5;

    private final DoubleFunction<SunAndMoonTables> make;
    /** The tables in the order of their last use. */
    private final Map<Double, SunAndMoonTables> tables = new LinkedHashMap<>(16, 0.75f, true);

    /** @param make called with a height, metres */
    public HeightCache(DoubleFunction<SunAndMoonTables> make) {
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
     * Returns the tables of an eye's shelf, or while that is being prepared the nearest one of two shelves on either
     * side, so that an eye that rises waits for nothing; without one of these the eye's own, ready or not.
     */
    public SunAndMoonTables near(double heightMetres, SunAndMoon lights) {
        double place = shelvesBelow(Math.max(2, heightMetres));
        SunAndMoonTables own = at(shelf(heightMetres));
        if (own.isReady(lights)) {
            return own;
        }
        SunAndMoonTables standIn = null;
        double least = MOST_APART;
        for (Map.Entry<Double, SunAndMoonTables> entry : tables.entrySet()) {
            double apart = Math.abs(shelvesBelow(entry.getKey()) - place);
            if (apart < least && entry.getValue().isReady(lights)) {
                standIn = entry.getValue();
                least = apart;
            }
        }
        if (standIn == null) {
            return own;
        }
        own.prepare(lights);
        return standIn;
    }

    private SunAndMoonTables at(double heightMetres) {
        SunAndMoonTables known = tables.get(heightMetres);
        if (known != null) {
            return known;
        }
        if (tables.size() == MOST) {
            Iterator<SunAndMoonTables> oldest = tables.values().iterator();
            oldest.next().close();
            oldest.remove();
        }
        SunAndMoonTables made = make.apply(heightMetres);
        tables.put(heightMetres, made);
        return made;
    }

    /** Closes all tables; others are made afterwards. */
    public void clear() {
        tables.values().forEach(GlObject::close);
        tables.clear();
    }

    @Override
    public void close() {
        clear();
    }
}
