/** The program: what each package holds, and which may know which, stands in docs/architecture.md. */
package sunbeam.app;
