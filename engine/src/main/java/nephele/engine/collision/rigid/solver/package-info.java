/**
 * The contact solvers. {@link nephele.engine.collision.rigid.solver.StepSolver} groups bodies into islands and chooses
 * for each between an exact block solver and substeps of sequential impulses.
 */
package nephele.engine.collision.rigid.solver;
