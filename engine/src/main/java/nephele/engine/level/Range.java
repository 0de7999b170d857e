package nephele.engine.level;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The numbers that a component of a written record may hold, in the unit that the component's name states. It stands on
 * every component of numbers, also on lists of them, and holds for each component of a vector. {@link NumberRange} is
 * what readers use: the parser, the rules, the schema, the editor and the generator of tests.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Range {
    /** Least number; the default is the size of the world in metres. */
    double min() default -1e7;

    /** Greatest number. */
    double max() default 1e7;

    Shape shape() default Shape.INTERVAL;

    /** The meaning of the two limits. */
    enum Shape {
        /** All numbers from least to greatest. */
        INTERVAL,
        /** Besides them 0, which means none or never. */
        OR_ZERO,
        /** Besides them the same numbers below zero: factors, which must not be zero. */
        EITHER_SIGN,
        /**
         * A vector whose length has no meaning: no component is beyond the greatest number, and at least one is as far
         * from zero as the least.
         */
        DIRECTION
    }
}
