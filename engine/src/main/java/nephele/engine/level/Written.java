package nephele.engine.level;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Describes a record component in a level file. Reading checks it, writing uses the default, and the schema states it.
 * {@link Range} states the numbers that it may hold.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Written {
    /** The JSON value of an absent key. If empty, the default of the type (empty list, {@code null}, 0, false). */
    String absent() default "";

    /** True if the key must be present. */
    boolean required() default false;

    /** The kind of a text. */
    TextKind text() default TextKind.NAME;

    /** Greatest number of entries of a list. */
    int most() default 10_000;

    /** True if the component's members are written beside its owner's instead of below a key. */
    boolean beside() default false;

    /** True if a record's members are written as an array, in their order and without their names. */
    boolean array() default false;

    /** Section whose ids a text names, such as {@code materials}; empty for a text that names no record. */
    String refersTo() default "";

    /** The meaning of a vector or a number in the world, by which the editor moves, turns and scales its record. */
    Spatial spatial() default Spatial.NONE;

    /** The JSON value of the component in a record that an editor makes; if empty, the editor derives one. */
    String prototype() default "";
}
