package nephele.engine.level;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** How a record component stands in a level file: what reading checks, writing leaves out and the schema says. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Written {
    /** The value of an absent key, as JSON. Empty: what the type has (empty list, {@code null}, 0, false). */
    String absent() default "";

    /** Whether the key must be there. */
    boolean required() default false;

    /** Smallest number, also for each component of a vector, in the unit that the name says. */
    double min() default -1e7;

    /** Largest number; the default is the size of the world in metres. */
    double max() default 1e7;

    /** What a text may consist of. */
    TextRule text() default TextRule.NAME;

    /** Most entries of a list. */
    int most() default 10_000;

    /** The component's members stand beside its owner's instead of below a key. */
    boolean beside() default false;
}
