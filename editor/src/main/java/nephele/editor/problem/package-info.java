/**
 * The problems of the open level, without Swing: found by the engine's rules on any thread, each with its place in the
 * world and the remedies that one click applies. {@link nephele.editor.problem.ProblemSearch} finds them.
 */
package nephele.editor.problem;
