/** What only a checkout builds: the proofs, the painters of the art, the solvers of the levels. Nothing uses it. */
package nephele.workshop;
